// How a mesh stands: morph targets with their weights, and skins as the nodes stand in the file.
#pragma once

#include "gltf_nodes.h"

#include <teapath/scene/mesh.h>

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

/// From a mesh's space to the world, as each joint of a skin moves it. Throws Error(Input) for
/// joints or matrices that do not exist; empty if a joint is not among the nodes of the scene.
std::vector<DoubleMat4> joint_matrices(const GltfDocument& document, int skin,
                                       const std::vector<GltfNode>& nodes);

/// Adds the targets to positions and normals. Throws Error(Input) at `where`.
void apply_morph(const GltfDocument& document, const tinygltf::Primitive& primitive,
                 const std::vector<double>& weights, const std::string& where, Mesh& mesh);

/// Which joints move each vertex and by how much: one list for each set of four.
struct SkinWeights {
    std::vector<std::vector<Float4>> joints, weights;
};

/// Moves the vertices to the world. Throws Error(Input) at `where` for a joint beyond the list.
void apply_skin(const SkinWeights& skin, const std::vector<DoubleMat4>& joints,
                const std::string& where, Mesh& mesh);

}  // namespace tp
