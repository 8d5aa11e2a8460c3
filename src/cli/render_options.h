// What `teapath render` was asked to do.
#pragma once

#include "arguments.h"

#include <teapath/render/backend.h>
#include <teapath/scene/scene.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tp {

struct RenderOptions {
    std::filesystem::path scene;
    std::vector<std::filesystem::path> outputs;

    // Instead of what the scene says
    std::optional<int> samples;
    std::optional<double> seconds;  // stop after; without `samples`, there is no other limit
    std::optional<ImageSize> size;
    std::optional<int> depth;
    std::optional<uint64_t> seed;
    std::optional<std::string> camera;
    std::vector<std::string> settings;  // "path.to.setting=value"

    std::optional<FrameRange> frames;  // none: one picture at the scene's time
    double frames_per_second = 24;

    BackendKind backend = BackendKind::Auto;
    int device = 0;
    int threads = 0;  // 0 = all cores
    bool quiet = false;
    bool denoise = false;  // false: as the scene says
};

/// The scene with the options' settings in place, checked. Throws Error(Usage) that names the
/// option where one makes the scene impossible.
Scene apply_options(const Scene& scene, const RenderOptions& options);

}  // namespace tp
