// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tp {

/// Writes a temporary file beside `file` and renames it. Throws Error(Output); then the old file,
/// if there was one, is as it was.
void write_whole_file(const std::filesystem::path& file, std::string_view bytes);

/// All bytes of a regular file (or pipe) of at most `limit` bytes. Throws Error(Input); `kind` is
/// the word for what was wanted: "a scene file (.json)".
std::string read_whole_file(const std::filesystem::path& file, const char* kind, uintmax_t limit);

}  // namespace tp
