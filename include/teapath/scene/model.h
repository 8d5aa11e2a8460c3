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

/// A light without a size, in the units of glTF's KHR_lights_punctual. The renderer has none yet.
struct ModelLight {
    enum class Kind : uint8_t { Point, Spot, Directional };
    std::string name;
    Kind kind = Kind::Point;
    Double3 color{1, 1, 1};          // linear
    double intensity = 1;            // candela; Directional: lux
    double range = 0;                // scene units; 0 = without end
    double inner_cone = 0;           // Spot: degrees from the axis, up to which it is whole
    double outer_cone = 45;          // Spot: degrees from the axis, from which it is none
    DoubleMat4 world_from_light{1};  // it shines along -z
    ModelPart part;

    friend bool operator==(const ModelLight&, const ModelLight&) = default;
};

/// What a model file holds. Ids count from 1 within each list; every thing has its ModelPart::path,
/// which is the same however often the file is read, and differs between things of a list.
struct ModelContent {
    std::vector<Object> objects;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Camera> cameras;
    std::vector<ModelLight> lights;
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
