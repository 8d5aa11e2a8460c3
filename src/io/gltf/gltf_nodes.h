// The tree of nodes of a glTF scene, as a list with world matrices and paths.
#pragma once

#include "gltf_document.h"

#include <teapath/core/math.h>

#include <string>
#include <vector>

namespace tp {

struct GltfNode {
    size_t index;      // in the file
    std::string name;  // different from its siblings'
    std::string path;  // names from the root on, parted by slashes
    DoubleMat4 world;
};

/// Scale, then rotation (a quaternion x y z w of any length), then translation.
DoubleMat4 placement_matrix(Double3 translation, Double4 rotation, Double3 scale);

/// The nodes of the file's scene (the first one where it names none; all roots where there are no
/// scenes), parents first. Throws Error(Input) if a node has two parents, is its own ancestor, does
/// not exist, or lies deeper than 1000 levels.
std::vector<GltfNode> nodes_of_scene(const GltfDocument& document);

}  // namespace tp
