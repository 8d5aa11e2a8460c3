// Models: files that bring objects, materials, textures and cameras of their own. Their things
// stand in the scene's lists like others, and know their ModelPart; the scene file keeps the
// model's path and what the user changed, by the name that the file has for each thing.
#pragma once

#include <teapath/scene/camera.h>
#include <teapath/scene/material.h>
#include <teapath/scene/object.h>
#include <teapath/scene/texture.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tp {

struct ModelMotion;
struct Scene;

/// A light without a size, in the units of glTF's KHR_lights_punctual.
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
    std::shared_ptr<const ModelMotion> motion;  // scene/pose.h; null: nothing moves
    std::vector<std::string> unsupported;       // what was left out, a sentence each
};

struct Model {
    ModelId id;
    std::string name;
    std::string path;                             // relative to the scene file
    Transform transform;                          // of all its objects, after their own
    std::string animation = "all";                // name of the one that plays, or "none"
    std::shared_ptr<const ModelContent> content;  // null: the file is missing
    std::string kept_changes;  // JSON of what was changed, kept where the file is missing

    // Content follows from the file.
    friend bool operator==(const Model& a, const Model& b) {
        return a.id == b.id && a.name == b.name && a.path == b.path && a.transform == b.transform &&
               a.animation == b.animation && a.kept_changes == b.kept_changes;
    }
};

/// Adds an object that shines, with its material, for each of the content's lights: a ball or a
/// disk of a hundredth of the model's size, for directional ones a disk as large in the sky as the
/// sun. Their parts are called "light:" and the light's path.
void add_lamps(ModelContent& content);

/// Moves an object by an affine map of the world. What a Transform cannot say of it goes into the
/// placement of a mesh; other shapes lose it.
void move_object(Object& object, const DoubleMat4& change);

/// What a model brings, as things of a scene: with the scene's ids, placed by the model.
struct ModelThings {
    std::vector<Object> objects;
    std::vector<Material> materials;
    std::vector<Texture> textures;
};

/// The scene's ids of a model's materials and textures, by ModelPart::path.
struct ModelIds {
    std::map<std::string, MaterialId> materials;
    std::map<std::string, TextureId> textures;
};

/// The model's things as its file has them. What `ids` lacks gets the id 0; objects have none.
ModelThings things_of(const Model& model, const ModelIds& ids);

/// The ids that the scene's things of that model have.
ModelIds ids_of(const Scene& scene, ModelId model);

/// Adds the model and its things under fresh ids; names of materials and textures that are taken
/// get a number. Its cameras are not added. The model's id is set here and returned.
ModelId add_model(Scene& scene, Model model);

/// The corners of a box around the meshes of the objects that are visible; [-1, 1]^3 if there are
/// none.
std::pair<Double3, Double3> box_of(const std::vector<Object>& objects);

/// A camera that has all meshes of the objects in view, from the front, a little from the right and
/// from above; `aspect` is width by height of the picture.
Camera camera_in_front(const std::vector<Object>& objects, double aspect);

/// A scene of that model alone: its cameras, or one that has it all in view, and a sky and a lamp
/// where it has no light of its own.
Scene scene_of_model(Model model);

}  // namespace tp
