// Files that are part of the program: shaders and fonts. src/app/CMakeLists.txt lists them.
#pragma once

#include <cstddef>
#include <string_view>

namespace tp {

/// The bytes of a file by its name, for as long as the program runs. Throws std::logic_error for a
/// name that is not in the list.
std::string_view embedded_file(std::string_view name);

}  // namespace tp
