// The two forms of a glTF file: JSON text, or a GLB container with the JSON and a binary chunk.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tp {

struct GltfContainer {
    std::string_view json;
    std::optional<std::string_view> binary;
};

/// Views of the bytes, which start with "glTF" if they are a GLB container. Throws Error(Input).
GltfContainer open_container(std::string_view bytes, const std::string& name);

}  // namespace tp
