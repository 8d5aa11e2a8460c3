// Models: files that bring objects, materials, textures and cameras of their own. The scene file
// keeps the model's path and what the user changed, by the name that the file has for each thing.
#pragma once

#include <teapath/scene/camera.h>
#include <teapath/scene/material.h>
#include <teapath/scene/object.h>
#include <teapath/scene/texture.h>

#include <memory>
#include <string>
#include <vector>

namespace tp {

/// What a model file holds. Ids count from 1 within each list; every thing has its ModelPart::path,
/// which is the same however often the file is read, and differs between things of a list.
struct ModelContent {
    std::vector<Object> objects;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Camera> cameras;
    std::vector<std::string> unsupported;  // what was left out, a sentence each
};

struct Model {
    ModelId id;
    std::string name;
    std::string path;                             // relative to the scene file
    std::shared_ptr<const ModelContent> content;  // null: the file is missing

    // Content follows from the file.
    friend bool operator==(const Model& a, const Model& b) {
        return a.id == b.id && a.name == b.name && a.path == b.path;
    }
};

}  // namespace tp
