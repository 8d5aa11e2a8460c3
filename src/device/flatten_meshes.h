// Meshes and their instances: which there are, and where.
#pragma once

#include <teapath/device/scene_arrays.h>

#include <unordered_map>

namespace tp {

/// Gathers the instances of a scene anew, and the meshes that they show; what arrays.meshes holds
/// from before is taken over.
class MeshCollector {
public:
    explicit MeshCollector(SceneArrays& arrays);

    /// Adds an instance for a visible object with a MeshShape, and fills h.mesh. False if it
    /// reaches beyond the kernels' numbers or is flat; then nothing is added.
    bool place(const Object& object, Hittable& h);

    /// Drops the meshes that nobody else holds: those of undone edits stay.
    void finish();

private:
    uint32_t index_of(const std::shared_ptr<const Mesh>& mesh);

    SceneArrays& arrays_;
    std::unordered_map<const Mesh*, uint32_t> index_;
};

}  // namespace tp
