#include "texture_packer.h"

#include <teapath/scene/texture_uses.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tp {
namespace {

WrapMode wrap_v_of(const Texture& texture) {
    switch (texture.wrap_v) {
        case WrapModeV::Repeat: return WrapMode::Repeat;
        case WrapModeV::Clamp: return WrapMode::Clamp;
        case WrapModeV::Mirror: return WrapMode::Mirror;
        case WrapModeV::AsU: break;
    }
    return texture.wrap;
}

// The finest features of a pattern in a unit of its space. Octaves of less than a tenth of the
// weight are passed over.
double detail_of(const Texture& t) {
    if (t.kind == TextureKind::Brick) {
        const double joint = t.mortar_width * std::min(t.mortar_blend, 1.0);
        return 1 / std::max(joint, 0.02 * std::min(t.brick_size.x, t.brick_size.y));
    }
    double detail = std::max({std::abs(t.scale.x), std::abs(t.scale.y), std::abs(t.scale.z)});
    if (t.kind == TextureKind::Wood) return 14 * detail;  // its fibres
    double weight = 1;
    const bool is_one = t.kind == TextureKind::Noise && t.pattern == NoisePattern::Gradient;
    for (int i = 1; i < t.octaves && !is_one; ++i) {
        weight *= t.gain;
        if (weight < 0.1) break;
        detail *= t.lacunarity;
    }
    return detail;
}

}  // namespace

bool is_srgb(const Image& image, ColorSpace space) {
    return space == ColorSpace::Srgb ||
           (space == ColorSpace::Auto && image.format != PixelFormat::F32);
}

TexturePacker::TexturePacker(const Scene& scene, SceneArrays& arrays)
    : scene_(scene), arrays_(arrays) {
    for (size_t i = 0; i < scene.textures.size(); ++i)
        index_[scene.textures[i].id.value] = static_cast<int32_t>(i);
    arrays.textures.assign(scene.textures.size(), {});
    arrays.texels.clear();
    for (size_t i = 0; i < scene.textures.size(); ++i)
        arrays.textures[i] = record_of(scene.textures[i]);
}

ColorRef TexturePacker::color_ref(const TexturedColor& c, double scale) const {
    return {Vec3(c.color * scale), index_of(c.texture)};
}

int32_t TexturePacker::index_of(TextureId id) const {
    const auto found = index_.find(id.value);
    return id && found != index_.end() ? found->second : -1;
}

NumberRef TexturePacker::number_ref(const TexturedNumber& n) const {
    return {static_cast<Real>(n.value), index_of(n.texture), static_cast<int>(n.channel)};
}

int32_t TexturePacker::add_image(const std::shared_ptr<const Image>& image, ColorSpace space) {
    if (!image) return -1;
    Texture texture;
    texture.kind = TextureKind::Image;
    texture.file.image = image;
    texture.color_space = space;
    arrays_.textures.push_back(record_of(texture));
    return static_cast<int32_t>(arrays_.textures.size()) - 1;
}

bool TexturePacker::has_alpha(const TexturedColor& c) {
    const auto found = index_.find(c.texture.value);
    if (!c.texture || found == index_.end()) return false;
    // Each texture is looked into once, however many checkers share it.
    const auto [known, is_new] = alpha_.try_emplace(c.texture.value, false);
    if (!is_new) return known->second;
    const Texture& texture = scene_.textures[static_cast<size_t>(found->second)];
    const TexturePair pair = pair_of(texture);
    const bool alpha = pair.first ? has_alpha(*pair.first) || has_alpha(*pair.second)
                                  : texture.kind == TextureKind::Image && texture.file.image &&
                                        texture.file.image->channels % 2 == 0;
    return alpha_[c.texture.value] = alpha;
}

bool TexturePacker::has_procedural() const {
    return std::any_of(scene_.textures.begin(), scene_.textures.end(), [](const Texture& t) {
        return is_blend(t.kind) ||
               (t.kind == TextureKind::Image && t.projection == TextureProjection::Triplanar);
    });
}

TextureRecord TexturePacker::record_of(const Texture& texture) {
    TextureRecord record;
    record.kind = texture.kind;
    if (texture.kind == TextureKind::Constant) {
        record.constant = Vec3(texture.color);
    } else if (texture.kind == TextureKind::Checker) {
        record.checker = {color_ref(texture.even), color_ref(texture.odd), texture.mode,
                          Vec2(texture.cells), static_cast<Real>(texture.frequency)};
    } else if (is_blend(texture.kind)) {
        record.pattern = pattern_record(texture);
    } else if (!texture.file.image) {
        record.kind = TextureKind::Constant;
        record.constant = {0, 1, 1};  // missing: cyan
    } else {
        record.image = image_record(texture);
    }
    return record;
}

ImageRecord TexturePacker::image_record(const Texture& texture) {
    const Image& image = *texture.file.image;
    const int bytes = image.format == PixelFormat::U8    ? 1
                      : image.format == PixelFormat::U16 ? 2
                                                         : 4;
    const bool srgb = is_srgb(image, texture.color_space);
    const double angle = texture.uv_rotation * kRadiansPerDegree;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    return {offset_of(image),
            image.width,
            image.height,
            static_cast<int16_t>(image.channels),
            static_cast<uint8_t>(bytes),
            srgb,
            static_cast<uint8_t>(texture.uv_set),
            texture.wrap,
            wrap_v_of(texture),
            texture.filter,
            Vec3(cosine * texture.repeat.x, sine * texture.repeat.y, texture.uv_offset.x),
            Vec3(-sine * texture.repeat.x, cosine * texture.repeat.y, texture.uv_offset.y),
            Vec3(texture.tint),
            texture.projection,
            texture.space,
            static_cast<Real>(texture.sharpness)};
}

PatternRecord TexturePacker::pattern_record(const Texture& t) const {
    const TexturePair pair = pair_of(t);
    PatternRecord r;
    r.first = color_ref(*pair.first);
    r.second = color_ref(*pair.second);
    r.key = tea_key(0, static_cast<uint64_t>(t.seed));
    r.rounds = static_cast<uint8_t>(t.tea_rounds);
    r.octaves = static_cast<uint8_t>(t.octaves);
    r.pattern = t.pattern;
    r.space = t.space;
    r.axis = t.axis;
    r.detail = static_cast<Real>(detail_of(t));
    r.scale = t.kind == TextureKind::Brick
                  ? Vec3(Double3(t.brick_size.x, t.brick_size.y, t.mortar_width))
                  : Vec3(t.scale);
    r.lacunarity = static_cast<Real>(t.lacunarity);
    r.gain = static_cast<Real>(t.gain);
    r.contrast = static_cast<Real>(t.kind == TextureKind::Noise    ? t.contrast
                                   : t.kind == TextureKind::Marble ? t.vein_power
                                   : t.kind == TextureKind::Wood   ? t.grain
                                                                   : t.variation);
    r.distortion = static_cast<Real>(t.kind == TextureKind::Brick ? t.row_offset : t.distortion);
    r.edge = static_cast<Real>(t.mortar_blend);
    return r;
}

uint64_t TexturePacker::offset_of(const Image& image) {
    const auto [entry, is_new] = offsets_.try_emplace(&image, 0);
    if (is_new) {
        entry->second = (arrays_.texels.size() + 15) / 16 * 16;
        arrays_.texels.resize(entry->second + image.bytes.size());
        std::memcpy(arrays_.texels.data() + entry->second, image.bytes.data(), image.bytes.size());
    }
    return entry->second;
}

}  // namespace tp
