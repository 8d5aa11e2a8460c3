// Model files: glTF and GLB, OBJ with its materials, PLY and STL, read whole into a ModelContent.
#pragma once

#include <teapath/scene/model.h>

#include <filesystem>
#include <functional>

namespace tp {

struct ModelReadOptions {
    bool allow_outside = false;  // files that the model names may lie outside its folder
    /// Hears the share that is done, from 0 to 1, on any thread but one at a time; false stops.
    std::function<bool(double)> progress;
};

/// True if the extension (lower or upper case) is .gltf, .glb, .obj, .ply or .stl.
bool can_read_model(const std::filesystem::path& file);

/// Reads the file with the buffers, images and materials that it names, on all cores. What cannot
/// be shown is a sentence in ModelContent::unsupported; missing images too. Throws Error(Input)
/// with file, place and remedy for what is broken, needs more memory than there is, or was stopped.
ModelContent read_model(const std::filesystem::path& file, const ModelReadOptions& options = {});

}  // namespace tp
