#include "flatten_meshes.h"

namespace tp {
namespace {

Affine affine_of(const DoubleMat4& m) {
    return {Mat3(DoubleMat3(m)), Vec3(Double3(m[3]))};
}

// The box of a box's eight corners.
Bounds placed_bounds(const Bounds& b, const DoubleMat4& world_from_object) {
    Bounds placed;
    for (int corner = 0; corner < 8; ++corner) {
        const Double4 p((corner & 1) ? b.high.x : b.low.x, (corner & 2) ? b.high.y : b.low.y,
                        (corner & 4) ? b.high.z : b.low.z, 1);
        placed = join(placed, Vec3(Double3(world_from_object * p)));
    }
    return placed;
}

}  // namespace

MeshCollector::MeshCollector(SceneArrays& arrays) : arrays_(arrays) {
    arrays.instances.clear();
    for (size_t i = 0; i < arrays.meshes.size(); ++i)
        if (const auto source = arrays.meshes[i].source.lock())
            index_[source.get()] = static_cast<uint32_t>(i);
}

bool MeshCollector::place(const Object& object, Hittable& h) {
    const auto& shape = std::get<MeshShape>(object.shape);
    const DoubleMat4 world_from_object =
        tp::world_from_object(object.transform) * DoubleMat4(shape.placement);
    InstanceRecord instance;
    instance.world_from_object = affine_of(world_from_object);
    instance.object_from_world = affine_of(glm::inverse(world_from_object));
    if (!is_finite(instance.world_from_object) || !is_finite(instance.object_from_world))
        return false;
    instance.mesh = index_of(shape.file.mesh);
    instance.smooth = shape.smooth;
    h.mesh.bounds = placed_bounds(arrays_.meshes[instance.mesh].arrays->bounds, world_from_object);
    if (!tp::is_finite(h.mesh.bounds.extent())) return false;
    h.mesh.instance = static_cast<uint32_t>(arrays_.instances.size());
    arrays_.instances.push_back(instance);
    return true;
}

void MeshCollector::finish() {
    std::vector<bool> used(arrays_.meshes.size());
    for (const InstanceRecord& instance : arrays_.instances)
        used[instance.mesh] = true;
    std::vector<uint32_t> moved(arrays_.meshes.size());
    std::vector<MeshOfScene> kept;
    for (size_t i = 0; i < used.size(); ++i) {
        moved[i] = static_cast<uint32_t>(kept.size());
        if (used[i] || !arrays_.meshes[i].source.expired())
            kept.push_back(std::move(arrays_.meshes[i]));
    }
    for (InstanceRecord& instance : arrays_.instances)
        instance.mesh = moved[instance.mesh];
    arrays_.meshes = std::move(kept);
}

uint32_t MeshCollector::index_of(const std::shared_ptr<const Mesh>& mesh) {
    const auto [entry, is_new] =
        index_.try_emplace(mesh.get(), static_cast<uint32_t>(arrays_.meshes.size()));
    if (is_new) arrays_.meshes.push_back({mesh, arrays_of(mesh)});
    return entry->second;
}

}  // namespace tp
