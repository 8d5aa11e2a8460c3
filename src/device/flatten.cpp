// From the document to the flat arrays, part by part.
#include "flatten_materials.h"
#include "flatten_meshes.h"
#include "flatten_shapes.h"

#include <teapath/core/parallel.h>
#include <teapath/device/bvh_build.h>
#include <teapath/device/camera_record.h>
#include <teapath/device/light_build.h>
#include <teapath/device/scene_arrays.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace tp {
namespace {

// A box that holds the hittable for certain, and has some thickness along each axis.
Bounds padded_bounds(const Hittable& h) {
    Bounds b = bounds_of(h);
    const Vec3 size = max(abs(b.low), abs(b.high));
    const Vec3 pad = size * error_bound(Real(0.5)) + Vec3(std::numeric_limits<Real>::min());
    return {b.low - pad, b.high + pad};
}

uint8_t hidden_from(const Object& object) {
    return static_cast<uint8_t>((object.camera_visible ? 0 : kRayCamera) |
                                (object.casts_shadows ? 0 : kRayShadow) |
                                (object.reflection_visible ? 0 : kRayScattered));
}

// Notes how the world lies in the space of an object that is a shape; nothing where both are one.
void note_placement(const Object& object, uint32_t hittable, SceneArrays& arrays) {
    if (object.transform == Transform{}) return;
    const DoubleMat4 map = glm::inverse(world_from_object(object.transform));
    const Affine affine{Mat3(DoubleMat3(map)), Vec3(Double3(map[3]))};
    if (is_finite(affine)) arrays.placements.push_back({hittable, affine});
}

void flatten_geometry(const Scene& scene, SceneArrays& arrays) {
    // The hittables of what can be seen, in the objects' order. What reaches beyond the kernels'
    // numbers is left out.
    const MaterialIndex material_index = index_materials(scene);
    std::vector<std::optional<Hittable>> shapes(scene.objects.size());
    parallel_for(static_cast<int64_t>(shapes.size()), 4096, [&](int64_t first, int64_t last) {
        for (auto i = static_cast<size_t>(first); i < static_cast<size_t>(last); ++i) {
            const Object& object = scene.objects[i];
            if (!object.visible) continue;
            shapes[i] = flatten_shape(object);
            if (shapes[i] && shapes[i]->kind != HittableKind::Mesh &&
                !is_finite(bounds_of(*shapes[i]).extent()))
                shapes[i].reset();
            if (!shapes[i]) continue;
            const auto found = material_index.find(object.material.value);
            shapes[i]->material = found == material_index.end() ? 0 : found->second;
            shapes[i]->object = object.id.value;
            shapes[i]->hidden_from = hidden_from(object);
        }
    });
    std::vector<Hittable> hittables;
    std::vector<uint32_t> objects;  // of each
    hittables.reserve(shapes.size());
    objects.reserve(shapes.size());
    MeshCollector meshes(arrays);
    for (size_t i = 0; i < shapes.size(); ++i) {
        if (!shapes[i]) continue;
        if (shapes[i]->kind == HittableKind::Mesh && !meshes.place(scene.objects[i], *shapes[i]))
            continue;
        hittables.push_back(*shapes[i]);
        objects.push_back(static_cast<uint32_t>(i));
    }
    meshes.finish();

    // The tree, and the hittables in the order of its leaves.
    std::vector<Bounds> boxes(hittables.size());
    parallel_for(static_cast<int64_t>(boxes.size()), 8192, [&](int64_t first, int64_t last) {
        for (auto i = static_cast<size_t>(first); i < static_cast<size_t>(last); ++i)
            boxes[i] = padded_bounds(hittables[i]);
    });
    BvhTree tree = build_bvh(boxes);
    arrays.hittables.resize(hittables.size());
    arrays.placements.clear();
    arrays.features &= ~(kFeatureShapes | kFeatureMeshes | kFeatureHiding);
    if (!arrays.instances.empty()) arrays.features |= kFeatureMeshes;
    for (size_t i = 0; i < hittables.size(); ++i) {
        arrays.hittables[i] = hittables[tree.order[i]];
        if (arrays.hittables[i].kind != HittableKind::Sphere) arrays.features |= kFeatureShapes;
        if (arrays.hittables[i].hidden_from != 0) arrays.features |= kFeatureHiding;
        if (arrays.hittables[i].kind != HittableKind::Mesh)
            note_placement(scene.objects[objects[tree.order[i]]], static_cast<uint32_t>(i), arrays);
    }
    arrays.nodes = std::move(tree.nodes);
    arrays.bounds = tree.bounds;
    arrays.bvh = tree.stats;
}

void flatten_parameters(const Scene& scene, SceneArrays& arrays) {
    arrays.camera = camera_record(active_camera(scene),
                                  static_cast<double>(scene.render.width) / scene.render.height);
    arrays.settings = scene.render.path;
    if (arrays.settings.integrator == IntegratorKind::Book) {
        arrays.settings.light_sampling = false;
        arrays.settings.roulette_depth = 0;
    } else {
        arrays.settings.scatter = ScatterRule::Cosine;
    }
    arrays.features &= ~(kFeatureSobol | kFeatureDebug);
    if (scene.render.path.sampler == SamplerKind::Sobol) arrays.features |= kFeatureSobol;
    if (scene.render.path.integrator == IntegratorKind::Normal ||
        scene.render.path.integrator == IntegratorKind::Flat)
        arrays.features |= kFeatureDebug;
}

// Equal but for names, which are no part of the image.
template <class T>
bool looks_same(const T& a, const T& b) {
    if (a == b) return true;
    if (a.name == b.name) return false;
    T renamed = a;
    renamed.name = b.name;
    return renamed == b;
}
// Objects may have meshes of one file in two forms.
bool looks_same(const Object& a, const Object& b) {
    const auto* x = std::get_if<MeshShape>(&a.shape);
    const auto* y = std::get_if<MeshShape>(&b.shape);
    if (x && y && x->file.mesh != y->file.mesh) return false;
    return looks_same<Object>(a, b);
}
template <class T>
bool all_look_same(const SharedList<T>& a, const SharedList<T>& b) {
    if (&a.items() == &b.items()) return true;
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const T& x, const T& y) { return looks_same(x, y); });
}

template <class T>
size_t bytes_of(const std::vector<T>& v) {
    return v.size() * sizeof(T);
}

}  // namespace

size_t SceneArrays::bytes() const {
    size_t sum = bytes_of(hittables) + bytes_of(nodes) + bytes_of(instances) +
                 bytes_of(placements) + bytes_of(lights) + bytes_of(light_nodes) +
                 bytes_of(materials) + bytes_of(principled) + bytes_of(material_ids) +
                 bytes_of(textures) + bytes_of(texels);
    if (environment) sum += environment->bytes();
    for (const MeshOfScene& mesh : meshes)
        sum += mesh.arrays->bytes();
    return sum;
}

void flatten(const Scene& scene, SceneParts parts, SceneArrays& arrays) {
    std::optional<Scene> expanded;
    if (!scene.generators.empty()) expanded = expand_generators(scene);
    const Scene& full = expanded ? *expanded : scene;

    if (has(parts, SceneParts::Materials)) flatten_materials(full, arrays);
    if (has(parts, SceneParts::Geometry)) flatten_geometry(full, arrays);
    if (has(parts, SceneParts::Materials) || has(parts, SceneParts::Geometry)) {
        build_lights(arrays);
        arrays.features &= ~kFeatureLights;
        if (!arrays.lights.empty() || arrays.background.light_probability > 0)
            arrays.features |= kFeatureLights;
    }
    if (has(parts, SceneParts::Parameters)) flatten_parameters(full, arrays);
}

SceneParts changed_parts(const Scene& before, const Scene& after) {
    SceneParts parts = SceneParts::None;
    const auto same_ids = [](const auto& a, const auto& b) {
        if (&a.items() == &b.items()) return true;
        return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                          [](const auto& x, const auto& y) { return x.id == y.id; });
    };
    // Records are numbered in the order of the materials, so that order is part of the geometry.
    if (!all_look_same(before.objects, after.objects)) parts = parts | SceneParts::Geometry;
    if (!all_look_same(before.generators, after.generators) ||
        !same_ids(before.materials, after.materials))
        parts = parts | SceneParts::Geometry | SceneParts::Materials;
    if (!all_look_same(before.materials, after.materials) ||
        !all_look_same(before.textures, after.textures) || before.background != after.background)
        parts = parts | SceneParts::Materials;
    if (!looks_same(active_camera(before), active_camera(after)) ||
        before.render.path != after.render.path || before.render.width != after.render.width ||
        before.render.height != after.render.height)
        parts = parts | SceneParts::Parameters;
    return parts;
}

}  // namespace tp
