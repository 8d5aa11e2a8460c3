// glTF 2.0 as a model.
#pragma once

#include "../model/model_source.h"

#include <teapath/scene/model.h>

#include <string>

namespace tp {

/// The default scene of a .gltf or .glb file, from its bytes. Throws Error(Input).
ModelContent read_gltf(std::string bytes, const ModelSource& source);

}  // namespace tp
