// Scene files: JSON, versioned; docs/scene_format.md and assets/scene.schema.json describe them.
#pragma once

#include <teapath/scene/scene.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace tp {

/// Reads a scene and the images that it names (relative to the file). A missing image is a
/// warning; every other problem throws Error(Input) with file, JSON path and remedy.
Scene load_scene(const std::filesystem::path& file);

/// The scene in a JSON text. `folder` is what relative paths start from, `name` stands for the
/// file in messages.
Scene parse_scene(std::string_view text, const std::filesystem::path& folder,
                  const std::string& name);

/// The JSON text of a scene: parse_scene(scene_text(s)) == s.
std::string scene_text(const Scene& scene);

/// Writes the file whole or not at all (a temporary file, renamed). Throws Error(Output).
void save_scene(const Scene& scene, const std::filesystem::path& file);

/// Changes one setting by its path in the JSON, as `--set render.path.max_depth=8` does; the value
/// is JSON, or a bare word for a string. Throws Error(Usage) for unknown paths, with the nearest.
Scene with_setting(const Scene& scene, std::string_view path, std::string_view value);

}  // namespace tp
