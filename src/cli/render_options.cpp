#include "render_options.h"

#include <teapath/core/error.h>
#include <teapath/core/nearest_name.h>
#include <teapath/io/scene_file.h>
#include <teapath/scene/validate.h>

#include <fmt/format.h>

namespace tp {
namespace {

Scene with_settings(Scene scene, const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) {
        const size_t equals = setting.find('=');
        if (equals == std::string::npos || equals == 0)
            throw Error(ErrorKind::Usage, fmt::format("'{}' has no value", setting), "--set",
                        "write --set path.to.setting=value, as in --set display.exposure=1.5");
        scene = with_setting(scene, std::string_view(setting).substr(0, equals),
                             std::string_view(setting).substr(equals + 1));
    }
    return scene;
}

CameraId camera_named(const Scene& scene, const std::string& name) {
    std::vector<std::string> names;
    for (const Camera& camera : scene.cameras) {
        if (camera.name == name) return camera.id;
        names.push_back(camera.name);
    }
    const std::string nearest = nearest_name(name, names);
    throw Error(ErrorKind::Usage, fmt::format("the scene has no camera '{}'", name), "--camera",
                fmt::format("{}it has '{}'",
                            nearest.empty() ? "" : fmt::format("did you mean '{}'? ", nearest),
                            fmt::join(names, "', '")));
}

// The option that set what a path in the scene's JSON names.
std::string option_of(const std::string& where, const RenderOptions& options) {
    // "render" is the number of pixels; the other options were in range when they were read.
    if (options.size && where == "render") return "--size";
    return "--set " + where;
}

}  // namespace

Scene apply_options(const Scene& scene, const RenderOptions& options) {
    // Single settings first, so that an option of its own has the last word.
    Scene changed = with_settings(scene, options.settings);
    RenderSettings& render = changed.render;
    if (options.samples) render.samples = *options.samples;
    if (options.size) {
        render.width = options.size->width;
        render.height = options.size->height;
    }
    if (options.depth) render.path.max_depth = *options.depth;
    if (options.denoise) render.denoise = true;
    if (options.seed) render.path.seed = *options.seed;
    if (options.camera) changed.active_camera = camera_named(changed, *options.camera);

    // The file was in order, so what is wrong now came from the command line.
    for (const Problem& problem : validate(changed)) {
        if (problem.fatal)
            throw Error(ErrorKind::Usage, problem.what, option_of(problem.where, options),
                        problem.remedy);
    }
    return changed;
}

}  // namespace tp
