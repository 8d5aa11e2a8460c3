// Which extensions of glTF are understood.
#pragma once

#include "gltf_document.h"

#include <string>
#include <vector>

namespace tp {

/// Throws Error(Input) if the file requires an extension that would leave it without sense;
/// returns a sentence for each that it uses and that is left out.
std::vector<std::string> check_extensions(const GltfDocument& document);

}  // namespace tp
