#include <teapath/editor/scene_edits.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

template <class T, class Id>
T* find_in(std::vector<T>& things, Id id) {
    const auto found =
        std::find_if(things.begin(), things.end(), [id](const T& t) { return t.id == id; });
    return id && found != things.end() ? &*found : nullptr;
}

template <class T>
auto next_id(const std::vector<T>& things) {
    decltype(T::id) id{0};
    for (const T& t : things)
        id.value = std::max(id.value, t.id.value);
    ++id.value;
    return id;
}

template <class T>
std::string free_name(const std::vector<T>& things, const std::string& wish) {
    const auto taken = [&](const std::string& name) {
        return std::any_of(things.begin(), things.end(),
                           [&](const T& t) { return t.name == name; });
    };
    if (!taken(wish)) return wish;
    for (int n = 2;; ++n)
        if (std::string name = fmt::format("{} {}", wish, n); !taken(name)) return name;
}

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
        {"Triangle", TriangleShape{{-0.5, -0.4, 0}, {0.5, -0.4, 0}, {0, 0.6, 0}}}};
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
    scene.objects.push_back(object);
    return object.id;
}

std::vector<ObjectId> duplicate_objects(Scene& scene, const std::vector<ObjectId>& ids) {
    std::vector<ObjectId> made;
    for (const ObjectId id : ids) {
        const Object* original = find(scene, id);
        if (!original) continue;
        Object copy = *original;
        copy.id = next_id(scene.objects);
        copy.name = free_name(scene.objects, display_name(*original));
        copy.transform.translation.x += extent_of(*original).radius * 1.2;
        made.push_back(copy.id);
        scene.objects.push_back(std::move(copy));
    }
    return made;
}

void delete_objects(Scene& scene, const std::vector<ObjectId>& ids) {
    std::erase_if(scene.objects, [&](const Object& o) {
        return std::find(ids.begin(), ids.end(), o.id) != ids.end();
    });
}

MaterialId add_material(Scene& scene, MaterialKind kind, MaterialId like) {
    Material material;
    if (const Material* original = find(scene, like))
        material = *original;
    else
        material.kind = kind;
    if (!like && kind == MaterialKind::Dielectric) material.color.color = {1, 1, 1};
    material.id = next_id(scene.materials);
    material.name = free_name(scene.materials, material.name.empty() ? "material" : material.name);
    scene.materials.push_back(material);
    return material.id;
}

TextureId add_texture(Scene& scene, TextureKind kind) {
    Texture texture;
    texture.id = next_id(scene.textures);
    texture.kind = kind;
    texture.name = free_name(scene.textures, kind == TextureKind::Image     ? "image"
                                             : kind == TextureKind::Checker ? "checker"
                                                                            : "colour");
    scene.textures.push_back(texture);
    return texture.id;
}

void realize_generators(Scene& scene) {
    scene = expand_generators(scene);
}

Object* find_object(Scene& scene, ObjectId id) {
    return find_in(scene.objects, id);
}
Material* find_material(Scene& scene, MaterialId id) {
    return find_in(scene.materials, id);
}
Texture* find_texture(Scene& scene, TextureId id) {
    return find_in(scene.textures, id);
}
Camera* find_camera(Scene& scene, CameraId id) {
    return find_in(scene.cameras, id);
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
