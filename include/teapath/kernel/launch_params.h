// Everything that a launch of the path tracer reads, passed by value.
#pragma once

#include <teapath/core/tea.h>
#include <teapath/kernel/scene_view.h>
#include <teapath/kernel/settings.h>

namespace tp {

struct LaunchParams {
    SceneView scene;
    CameraRecord camera;
    PathSettings settings;
    TeaKey key;  // of the random numbers, from settings.seed
    int32_t width = 0;
    int32_t height = 0;
};

}  // namespace tp
