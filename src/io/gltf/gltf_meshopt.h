// Buffer views that are compressed by EXT_meshopt_compression.
#pragma once

#include "gltf_document.h"

namespace tp {

/// Fills GltfDocument::decoded on all cores. Throws Error(Input) for data that do not decode or
/// would take more memory than there is.
void decode_meshopt_views(GltfDocument& document);

}  // namespace tp
