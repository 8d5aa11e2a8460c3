// Cameras and lights of a glTF file.
#pragma once

#include "gltf_nodes.h"

#include <teapath/scene/model.h>

#include <vector>

namespace tp {

/// Appends the perspective cameras of the nodes; each looks at the point of its axis that is
/// nearest to the middle of the objects. Throws Error(Input) for cameras that do not exist.
void add_cameras(const GltfDocument& document, const std::vector<GltfNode>& nodes,
                 ModelContent& content);

/// Appends the lights of KHR_lights_punctual. Throws Error(Input) as above.
void add_lights(const GltfDocument& document, const std::vector<GltfNode>& nodes,
                ModelContent& content);

}  // namespace tp
