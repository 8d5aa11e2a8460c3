#include "scene_things.h"

#include <teapath/editor/scene_edits.h>
#include <teapath/scene/enum_tables.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace tp {
namespace {

// The box of a shape in its own space.
struct LocalBox {
    Double3 low, high;
};
struct BoxOf {
    LocalBox operator()(const SphereShape& s) const {
        return {s.center - std::abs(s.radius), s.center + std::abs(s.radius)};
    }
    LocalBox operator()(const XyRectShape& r) const {
        return {{r.low.x, r.low.y, r.k}, {r.high.x, r.high.y, r.k}};
    }
    LocalBox operator()(const XzRectShape& r) const {
        return {{r.low.x, r.k, r.low.y}, {r.high.x, r.k, r.high.y}};
    }
    LocalBox operator()(const YzRectShape& r) const {
        return {{r.k, r.low.x, r.low.y}, {r.k, r.high.x, r.high.y}};
    }
    LocalBox operator()(const RectangleShape& r) const {
        const Double3 opposite = r.corner + r.edge_u + r.edge_v;
        return {glm::min(glm::min(r.corner, opposite),
                         glm::min(r.corner + r.edge_u, r.corner + r.edge_v)),
                glm::max(glm::max(r.corner, opposite),
                         glm::max(r.corner + r.edge_u, r.corner + r.edge_v))};
    }
    LocalBox operator()(const BoxShape& b) const { return {b.low, b.high}; }
    LocalBox operator()(const DiskShape& d) const {
        return {d.center - std::abs(d.radius), d.center + std::abs(d.radius)};
    }
    LocalBox operator()(const TriangleShape& t) const {
        return {glm::min(t.a, glm::min(t.b, t.c)), glm::max(t.a, glm::max(t.b, t.c))};
    }
    LocalBox operator()(const MeshShape& m) const {
        if (!m.file.mesh) return {Double3(-0.5), Double3(0.5)};
        const Double3 low = m.file.mesh->low, high = m.file.mesh->high;
        const Double3 center = m.placement * ((low + high) * 0.5);
        Double3 half(0);
        for (int axis = 0; axis < 3; ++axis)
            half += glm::abs(m.placement[axis]) * ((high - low)[axis] * 0.5);
        return {center - half, center + half};
    }
};

}  // namespace

const std::vector<ShapeKind>& shape_kinds() {
    static const std::vector<ShapeKind> kinds = {
        {"Sphere", SphereShape{{0, 0, 0}, 0.5}},
        {"Rectangle XY", XyRectShape{}},
        {"Rectangle XZ", XzRectShape{}},
        {"Rectangle YZ", YzRectShape{}},
        {"Rectangle", RectangleShape{}},
        {"Box", BoxShape{}},
        {"Disk", DiskShape{{0, 0, 0}, {0, 1, 0}, 0.5}},
        {"Triangle", TriangleShape{{-0.5, -0.4, 0}, {0.5, -0.4, 0}, {0, 0.6, 0}}},
        {"Mesh", MeshShape{}}};
    return kinds;
}

ObjectId add_object(Scene& scene, const ShapeKind& kind, const Double3& place, double size) {
    Object object;
    object.id = next_id(scene.objects);
    object.name = free_name(scene.objects, kind.label);
    object.shape = kind.shape;
    object.transform.translation = place;
    object.transform.scale = Double3(size);
    object.material = add_material(scene, MaterialKind::Lambertian);
    scene.objects.edit().push_back(object);
    return object.id;
}

std::vector<ObjectId> duplicate_objects(Scene& scene, const std::vector<ObjectId>& ids) {
    std::vector<ObjectId> made;
    // One pass finds them all, whatever their number.
    const std::set<ObjectId> wanted(ids.begin(), ids.end());
    ObjectId id = next_id(scene.objects);
    const size_t count = scene.objects.size();
    const bool names_anew = wanted.size() <= 100;  // a search for each would take long
    for (size_t i = 0; i < count; ++i) {
        if (!wanted.count(scene.objects[i].id)) continue;
        Object copy = scene.objects[i];
        copy.id = id;
        copy.part = {};
        if (names_anew && !copy.name.empty()) copy.name = free_name(scene.objects, copy.name);
        copy.transform.translation.x += extent_of(copy).radius * 1.2;
        made.push_back(copy.id);
        scene.objects.edit().push_back(std::move(copy));
        ++id.value;
    }
    return made;
}

void delete_objects(Scene& scene, const std::vector<ObjectId>& ids) {
    const std::set<ObjectId> unwanted(ids.begin(), ids.end());
    std::erase_if(scene.objects.edit(), [&](const Object& o) { return unwanted.count(o.id) > 0; });
}

MaterialId add_material(Scene& scene, const Material& like) {
    Material material = like;
    material.id = next_id(scene.materials);
    material.part = {};
    material.name = free_name(scene.materials, material.name.empty() ? "material" : material.name);
    scene.materials.edit().push_back(material);
    return material.id;
}

MaterialId add_material(Scene& scene, MaterialKind kind, MaterialId like) {
    if (const Material* original = find(scene, like))
        return add_material(scene, Material(*original));
    return add_material(scene, new_material(kind));
}

Material new_material(MaterialKind kind) {
    Material material;
    material.kind = kind;
    if (kind == MaterialKind::Dielectric || kind == MaterialKind::Conductor)
        material.color.color = {1, 1, 1};
    if (kind == MaterialKind::DiffuseLight) material.strength = 3;
    return material;
}

CameraId add_camera(Scene& scene, const Camera& like) {
    Camera camera = like;
    camera.id = next_id(scene.cameras);
    camera.name = free_name(scene.cameras, camera.name.empty() ? "camera" : camera.name);
    scene.cameras.push_back(camera);
    return camera.id;
}

GeneratorId add_sphere_grid(Scene& scene, const Double3& place) {
    Generator generator;
    generator.id = next_id(scene.generators);
    generator.name = free_name(scene.generators, "sphere grid");
    generator.grid.columns = generator.grid.rows = 6;
    generator.grid.center = {place.x, place.z};
    generator.grid.ground = place.y;
    scene.generators.edit().push_back(generator);
    return generator.id;
}

void assign_material(Scene& scene, const std::vector<ObjectId>& ids, MaterialId material) {
    const std::set<ObjectId> wanted(ids.begin(), ids.end());
    for (Object& o : scene.objects.edit())
        if (wanted.count(o.id)) o.material = material;
}

void set_visible(Scene& scene, const std::vector<ObjectId>& ids, bool visible) {
    const std::set<ObjectId> wanted(ids.begin(), ids.end());
    for (Object& o : scene.objects.edit())
        if (wanted.count(o.id)) o.visible = visible;
}

TextureId add_texture(Scene& scene, TextureKind kind) {
    Texture texture;
    texture.id = next_id(scene.textures);
    texture.kind = kind;
    texture.name =
        free_name(scene.textures, kind == TextureKind::Constant ? std::string("colour")
                                                                : std::string(enum_name(kind)));
    scene.textures.edit().push_back(texture);
    return texture.id;
}

void realize_generators(Scene& scene) {
    scene = expand_generators(scene);
}

Object* find_object(Scene& scene, ObjectId id) {
    return find_in(scene.objects.edit(), id);
}
Material* find_material(Scene& scene, MaterialId id) {
    return find_in(scene.materials.edit(), id);
}
Texture* find_texture(Scene& scene, TextureId id) {
    return find_in(scene.textures.edit(), id);
}
Camera* find_camera(Scene& scene, CameraId id) {
    return find_in(scene.cameras, id);
}
Generator* find_generator(Scene& scene, GeneratorId id) {
    return find_in(scene.generators.edit(), id);
}

std::string display_name(const Object& object) {
    if (!object.name.empty()) return object.name;
    return fmt::format("{} {}", shape_kinds()[object.shape.index()].label, object.id.value);
}

std::string display_name(const Material& material) {
    return material.name.empty() ? fmt::format("material {}", material.id.value) : material.name;
}

Extent extent_of(const Object& object) {
    const LocalBox box = std::visit(BoxOf{}, object.shape);
    const DoubleMat4 world = world_from_object(object.transform);
    const Double3 center = Double3(world * Double4((box.low + box.high) * 0.5, 1));
    double radius = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Double3 p{corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                        corner & 4 ? box.high.z : box.low.z};
        radius = std::max(radius, glm::distance(center, Double3(world * Double4(p, 1))));
    }
    return {center, std::max(radius, 1e-6)};
}

}  // namespace tp
