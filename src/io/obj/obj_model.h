// Wavefront OBJ with its materials as a model.
#pragma once

#include "../model/model_source.h"

#include <teapath/scene/model.h>

#include <string_view>

namespace tp {

/// One object for each group and material of the file. A missing library, material or image is a
/// sentence. Throws Error(Input).
ModelContent read_obj_model(std::string_view bytes, const ModelSource& source);

}  // namespace tp
