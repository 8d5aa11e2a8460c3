// The files that a render is to write, checked before it starts.
#pragma once

#include <filesystem>
#include <vector>

namespace tp {

/// Throws Error(Usage) for no file, a format that cannot be written or a file named twice, and
/// Error(Output) for a file that could not be written at the end.
void check_outputs(const std::vector<std::filesystem::path>& files);

/// What a file of some format holds.
enum class FileContent {
    Display,   // bytes after exposure and tone curve
    Radiance,  // linear radiance: HDR, PFM
    Layers     // linear radiance and the film's other planes: EXR
};
FileContent content_of(const std::filesystem::path& file);
bool any_has(const std::vector<std::filesystem::path>& files, FileContent content);

}  // namespace tp
