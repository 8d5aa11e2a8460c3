// The textures of an OBJ model: one for each different use of an image file.
#pragma once

#include "../model/model_progress.h"
#include "../model/unique_names.h"

#include <teapath/scene/model.h>

#include <tiny_obj_loader.h>

#include <map>
#include <string>
#include <vector>

namespace tp {

class ObjTextures {
public:
    ObjTextures(const ModelSource& source, ModelContent& content)
        : source_(source), content_(content), budget_(source) {}

    /// The id of the texture of an image file as an MTL line names it; 0 where `file` is empty.
    /// With `alpha`, the name of another file, that one's grey becomes the alpha.
    TextureId add(const std::string& file, const tinyobj::texture_option_t& options,
                  ColorSpace space, Double3 tint = Double3(1), const std::string& alpha = {});

    /// Reads the images on all cores. One that cannot be is a sentence.
    void load_images(ModelProgress& progress);

    /// True if the texture shows heights (a grey image), not directions; after load_images.
    bool is_grey(TextureId id) const;

private:
    struct Files {
        std::string color, alpha;
        auto operator<=>(const Files&) const = default;
    };
    std::shared_ptr<const Image> load(const Files& files);

    const ModelSource& source_;
    ModelContent& content_;
    ImageBudget budget_;
    std::map<std::string, TextureId> known_;
    std::vector<Files> files_;  // of each texture of the content
    UniqueNames paths_;
};

}  // namespace tp
