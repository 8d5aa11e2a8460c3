// The tree of nodes of a glTF scene, as a list with world matrices and paths.
#pragma once

#include "gltf_document.h"

#include <teapath/scene/pose.h>

#include <string>
#include <vector>

namespace tp {

struct GltfNode {
    size_t index;      // in the file
    std::string name;  // different from its siblings'
    size_t parent;     // in the list; kNoIndex: a root
    std::string path;  // names from the root on, parted by slashes
    DoubleMat4 own;    // in its parent
    DoubleMat4 world;
};

/// The nodes of the file's scene (the first one where it names none; all roots where there are no
/// scenes), parents first. Throws Error(Input) if a node has two parents, is its own ancestor, does
/// not exist, or lies deeper than 1000 levels.
std::vector<GltfNode> nodes_of_scene(const GltfDocument& document);

}  // namespace tp
