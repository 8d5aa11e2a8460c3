// The arrays as kernels that run on the host see them.
#pragma once

#include <teapath/device/scene_arrays.h>
#include <teapath/kernel/scene_view.h>

#include <vector>

namespace tp {

/// A view of the arrays, which must outlive it. `meshes` is filled for it and must do so too.
SceneView host_view(const SceneArrays& arrays, std::vector<MeshView>& meshes);

}  // namespace tp
