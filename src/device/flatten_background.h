// From the document's background to the kernels' record.
#pragma once

#include "texture_packer.h"

namespace tp {

/// Fills background and environment of `arrays`; images become records of `textures`.
void flatten_background(const Background& background, TexturePacker& textures, SceneArrays& arrays);

}  // namespace tp
