// Scenes to JSON trees and back, and what follows a reading: checks and images. For the files of
// this module; scene_file.h is what others see.
#pragma once

#include "json_text.h"
#include "model_cache.h"

#include <teapath/scene/scene.h>

#include <string>

namespace tp {

/// Throws Error(Input) with `name` as the file. Models are taken from `models`.
Scene scene_of_json(const Json& json, const std::string& name, ModelCache& models);

/// `with_defaults` also writes what has its default.
Json json_of_scene(const Scene& scene, bool with_defaults);

/// Throws the first fatal problem of the scene as Error(Input) with `name` as the file; logs the
/// others as warnings where `warn` says so.
void check_problems(const Scene& scene, const std::string& name, bool warn = true);

/// Loads the images that are named and not there, each once, from paths relative to the scene's
/// folder; `known` is a scene whose images are taken where the path is the same. A missing one is a
/// warning that starts with `name`, and stays null.
void load_images(Scene& scene, const std::string& name, ModelCache& models,
                 const Scene* known = nullptr);

/// The same for meshes; what is missing is not shown.
void load_meshes(Scene& scene, const std::string& name, ModelCache& models,
                 const Scene* known = nullptr);

}  // namespace tp
