// EXT_mesh_gpu_instancing: one node that stands for many.
#pragma once

#include "gltf_nodes.h"

#include <vector>

namespace tp {

/// The world matrices of a node's mesh: its own, or one for each of its instances. Throws
/// Error(Input) if the lists of the extension do not fit together.
std::vector<DoubleMat4> places_of(const GltfDocument& document, const GltfNode& node);

}  // namespace tp
