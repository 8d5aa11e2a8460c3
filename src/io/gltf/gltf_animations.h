// The animations of a glTF file.
#pragma once

#include "gltf_nodes.h"

#include <teapath/scene/model.h>

#include <set>
#include <string>
#include <vector>

namespace tp {

/// The animations, of which every channel drives one of `nodes`. What is broken or not supported is
/// left out, with a sentence in `unsupported`. Throws Error(Input) only for what would take more
/// memory than there is.
std::vector<Animation> read_animations(const GltfDocument& document,
                                       const std::vector<GltfNode>& nodes,
                                       std::vector<std::string>& unsupported);

/// The nodes as scene/pose.h has them.
std::vector<MotionNode> motion_nodes(const GltfDocument& document,
                                     const std::vector<GltfNode>& nodes);

/// Which of the nodes some animation moves, by themselves or with a parent.
std::vector<bool> moving_nodes(const std::vector<Animation>& animations,
                               const std::vector<GltfNode>& nodes);

/// Which of the nodes have morph targets whose weights some animation drives.
std::vector<bool> morphing_nodes(const std::vector<Animation>& animations, size_t nodes);

}  // namespace tp
