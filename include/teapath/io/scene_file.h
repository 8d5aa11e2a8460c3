// Scene files: JSON, versioned; docs/scene_format.md and assets/scene.schema.json describe them.
#pragma once

#include <teapath/io/model_file.h>
#include <teapath/scene/scene.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace tp {

/// Reads a scene and the models, meshes and images that it names (relative to the file). A missing
/// one is a warning; every other problem throws Error(Input) with file, JSON path and remedy. Of a
/// model file (model_file.h) it makes a scene with a camera and light.
Scene load_scene(const std::filesystem::path& file, const ModelReadOptions& options = {});

/// Reads a model file, as a model of a scene in the same folder. What it does not support is
/// logged. Throws Error(Input).
Model load_model(const std::filesystem::path& file, const ModelReadOptions& options = {});

/// The scene in a JSON text. `folder` is what relative paths start from, `name` stands for the
/// file in messages.
Scene parse_scene(std::string_view text, const std::filesystem::path& folder,
                  const std::string& name, const ModelReadOptions& options = {});

/// The JSON text of a scene, without what has its default. Reading it back gives a scene that
/// renders the same; it is equal to `scene` where that one came from a file, and the text of any
/// scene read back is the same text. Names that are used twice get a number.
std::string scene_text(const Scene& scene);

/// Writes the file whole or not at all (a temporary file, renamed). Relative paths in it are turned
/// to start from the folder of `file`. Throws Error(Output).
void save_scene(const Scene& scene, const std::filesystem::path& file);

/// Changes one setting by its path in the JSON, as `--set render.max_depth=8` does. Elements of
/// lists go by number or name: `objects[3].visible`, `objects.3.visible`, `cameras.front.aperture`;
/// `camera` is the active one. The value is JSON, or a bare word for a string. Throws Error(Usage)
/// for unknown paths, with the nearest known key.
Scene with_setting(const Scene& scene, std::string_view path, std::string_view value);

}  // namespace tp
