// Cameras between cameras: the way along a row of them, and round the point that one looks at.
#pragma once

#include <teapath/scene/scene.h>

#include <vector>

namespace tp {

/// The scene's cameras named "bookmark 1" to "bookmark 9", in that order.
std::vector<Camera> bookmark_cameras(const Scene& scene);

/// The camera at `t` in [0, 1] of the way past all keys, smooth in place and direction (Catmull-Rom
/// through each key, keys at equal steps of t). Name, id and clipping are of the first key. At
/// least one key.
Camera camera_on_path(const std::vector<Camera>& keys, double t);

/// The camera turned by `turns` full turns about the axis `up` through its look_at.
Camera camera_on_turntable(const Camera& camera, double turns);

}  // namespace tp
