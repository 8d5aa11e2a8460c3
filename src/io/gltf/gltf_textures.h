// The textures of a model: one for each different use of an image.
#pragma once

#include "../model/model_progress.h"
#include "../model/unique_names.h"
#include "gltf_document.h"

#include <teapath/scene/model.h>

#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace tp {

/// How a material uses a texture of the file.
struct TextureUse {
    int index = -1;  // of glTF's textures; below 0: none
    int uv_set = 0;
    Double2 offset{0, 0}, repeat{1, 1};
    double rotation = 0;  // radians
    double scale = 1;     // of a normal map
};

TextureUse use_of(const tinygltf::TextureInfo& info);
TextureUse use_of(const tinygltf::NormalTextureInfo& info);
/// The object under a key of an extension.
TextureUse use_in(const tinygltf::Value& object, const char* key);

/// Collects textures while materials are read, then loads the images that they use.
class GltfTextures {
public:
    static constexpr double kAsItIs = -1;

    GltfTextures(const GltfDocument& document, ModelContent& content)
        : document_(document), content_(content), budget_(*document.source) {}

    /// The id of the texture for such a use, 0 where there is none. Throws Error(Input) at `where`
    /// for an index that does not exist. With a `glossiness` from 0 upwards its pixels become
    /// roughness: 1 - glossiness * alpha.
    TextureId add(const TextureUse& use, ColorSpace space, const std::string& where,
                  Double3 tint = Double3(1), double glossiness = kAsItIs);

    /// Decodes the images on all cores. One that cannot be is a sentence.
    void load_images(ModelProgress& progress);

private:
    int image_of(const tinygltf::Texture& texture) const;
    std::shared_ptr<const Image> load(size_t image);

    using Key = std::tuple<int, int, double, double, double, double, double, int, double, double,
                           double, double>;
    struct Source {
        int image;
        double glossiness;
    };

    const GltfDocument& document_;
    ModelContent& content_;
    ImageBudget budget_;
    std::map<Key, TextureId> known_;
    std::vector<Source> sources_;  // of each texture of the content
    UniqueNames paths_;
    std::set<std::string> said_;
};

}  // namespace tp
