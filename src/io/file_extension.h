// The extension of a file's name, by which readers and writers are chosen.
#pragma once

#include <filesystem>
#include <string>

namespace tp {

/// With its dot, in lower case: ".obj" for "A.OBJ"; empty if there is none.
inline std::string lower_extension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

}  // namespace tp
