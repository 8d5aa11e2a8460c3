// Texture records, with each image's pixels packed once.
#pragma once

#include <teapath/device/scene_arrays.h>

#include <unordered_map>

namespace tp {

inline constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180;

/// True if the image's numbers are sRGB codes.
bool is_srgb(const Image& image, ColorSpace space);

/// Fills SceneArrays::textures and texels.
class TexturePacker {
public:
    /// Packs the scene's textures.
    TexturePacker(const Scene& scene, SceneArrays& arrays);

    ColorRef color_ref(const TexturedColor& c, double scale = 1) const;
    NumberRef number_ref(const TexturedNumber& n) const;
    /// Index of the texture's record, -1 for none.
    int32_t index_of(TextureId id) const;

    /// Adds a record for an image that is no texture of the scene; -1 if it is missing.
    int32_t add_image(const std::shared_ptr<const Image>& image, ColorSpace space);

    /// True if the colour's texture has an alpha channel.
    bool has_alpha(const TexturedColor& c);

    /// True if some texture needs kFeatureProcedural.
    bool has_procedural() const;

private:
    TextureRecord record_of(const Texture& texture);
    ImageRecord image_record(const Texture& texture);
    PatternRecord pattern_record(const Texture& texture) const;
    uint64_t offset_of(const Image& image);

    const Scene& scene_;
    SceneArrays& arrays_;
    std::unordered_map<uint32_t, int32_t> index_;
    std::unordered_map<const Image*, uint64_t> offsets_;
    std::unordered_map<uint32_t, bool> alpha_;
};

}  // namespace tp
