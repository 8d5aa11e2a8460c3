// How the scene names a file that was chosen.
#pragma once

#include <teapath/scene/scene.h>

#include <filesystem>
#include <string>

namespace tp {

/// From the scene's folder on, where the file lies below that; else the whole path.
inline std::string path_in_scene(const Scene& scene, const std::filesystem::path& file) {
    namespace fs = std::filesystem;
    const fs::path whole = fs::absolute(file).lexically_normal();
    if (scene.origin.folder.empty()) return whole.generic_string();
    const fs::path folder = fs::absolute(scene.origin.folder).lexically_normal();
    const fs::path relative = whole.lexically_relative(folder);
    return relative.empty() || *relative.begin() == ".." ? whole.generic_string()
                                                         : relative.generic_string();
}

}  // namespace tp
