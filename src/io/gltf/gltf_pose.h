// What gives a mesh its form: morph targets with their weights, and skins, read from the file.
// scene/deform.h applies them.
#pragma once

#include "gltf_nodes.h"

#include <teapath/scene/deform.h>

#include <compare>
#include <string>
#include <vector>

namespace tp {

/// Nodes of equal uses share their meshes.
struct MeshUse {
    size_t mesh = 0;
    int skin = -1;                // below 0: none
    std::vector<double> weights;  // of the morph targets; empty: none of them

    auto operator<=>(const MeshUse&) const = default;
};

/// What a node does with its mesh. Throws Error(Input) for a mesh or skin that does not exist.
MeshUse use_of_mesh(const GltfDocument& document, size_t node);

/// The skin with its joints among `nodes`; without joints if one of them is not there. Throws
/// Error(Input) for joints or matrices that do not exist.
MotionSkin read_skin(const GltfDocument& document, int skin, const std::vector<GltfNode>& nodes);

/// From a mesh's space to the world, as each joint of a skin moves it at rest.
std::vector<DoubleMat4> joint_matrices(const MotionSkin& skin, const std::vector<GltfNode>& nodes);

/// The targets of a primitive, as many as `weights`. Those with a weight of 0 are left empty unless
/// `all` are wanted. Throws Error(Input) at `where`.
std::vector<MorphTarget> read_targets(const GltfDocument& document,
                                      const tinygltf::Primitive& primitive,
                                      const std::vector<double>& weights, bool all,
                                      const std::string& where);

}  // namespace tp
