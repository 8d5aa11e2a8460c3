// What the program says: results on stdout, everything else on stderr.
#pragma once

#include <string_view>

namespace tp {

/// Writes to stderr. What cannot be written is lost: a closed terminal must not end a render.
void print_status(std::string_view text);

/// Writes to stdout and flushes. Throws Error(Output) where that fails, as on a full disk.
void print_result(std::string_view text);

}  // namespace tp
