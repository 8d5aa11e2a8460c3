// The scene's flat arrays in one packed device allocation: sizes summed, parts aligned, one copy.
// Meshes have their own, so that a change of the scene copies no mesh that is there.
#pragma once

#include <teapath/device/cuda_buffer.cuh>
#include <teapath/device/cuda_mesh.cuh>
#include <teapath/device/cuda_stream.cuh>
#include <teapath/device/scene_arrays.h>
#include <teapath/kernel/scene_view.h>

#include <vector>

namespace tp {

class CudaScene {
public:
    /// Copies the parts that changed; grows the allocation only where they no longer fit.
    void upload(const SceneArrays& arrays, SceneParts parts, const Stream& stream);

    const SceneView& view() const { return view_; }
    size_t bytes() const;

private:
    void upload_meshes(const std::vector<MeshOfScene>& meshes, const Stream& stream);

    SceneView view_;
    std::vector<CudaMesh> meshes_;
    DeviceBuffer<std::byte> memory_;
    std::shared_ptr<const EnvironmentArrays> environment_;  // whose tables memory_ holds
    std::vector<size_t> layout_;  // bytes of each part, of what memory_ holds
};

}  // namespace tp
