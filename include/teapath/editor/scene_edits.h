// What the Add and Edit menus do to a scene, as functions on the scene alone.
#pragma once

#include <teapath/scene/scene.h>

#include <array>
#include <string>
#include <vector>

namespace tp {

/// The shapes that the Add menu offers, in the order of the variant Shape.
struct ShapeKind {
    const char* label;
    Shape shape;
};
const std::vector<ShapeKind>& shape_kinds();

/// Adds a shape of about `size` around `place`; returns its id.
ObjectId add_object(Scene& scene, const ShapeKind& kind, const Double3& place, double size);

/// Copies objects, a little to the side; returns the new ids.
std::vector<ObjectId> duplicate_objects(Scene& scene, const std::vector<ObjectId>& ids);
void delete_objects(Scene& scene, const std::vector<ObjectId>& ids);

/// A new material with a free name, a copy of `like` where given; returns its id.
MaterialId add_material(Scene& scene, MaterialKind kind, MaterialId like = {});
MaterialId add_material(Scene& scene, const Material& like);
/// What a new material of that kind starts from: glass is clear, a light has the strength 3.
Material new_material(MaterialKind kind);
TextureId add_texture(Scene& scene, TextureKind kind);
CameraId add_camera(Scene& scene, const Camera& like);
/// A small grid of spheres around `place`, which is on their ground.
GeneratorId add_sphere_grid(Scene& scene, const Double3& place);

void assign_material(Scene& scene, const std::vector<ObjectId>& ids, MaterialId material);
void set_visible(Scene& scene, const std::vector<ObjectId>& ids, bool visible);

/// Turns generators into objects that can be edited one by one.
void realize_generators(Scene& scene);

/// The object itself, to be changed; null if there is none.
Object* find_object(Scene& scene, ObjectId id);
Material* find_material(Scene& scene, MaterialId id);
Texture* find_texture(Scene& scene, TextureId id);
Camera* find_camera(Scene& scene, CameraId id);
Generator* find_generator(Scene& scene, GeneratorId id);

/// What an object is called where it has no name.
std::string display_name(const Object& object);
std::string display_name(const Material& material);

/// Centre and radius of an object's surroundings, for framing and for the gizmo.
struct Extent {
    Double3 center;
    double radius;
};
Extent extent_of(const Object& object);

}  // namespace tp
