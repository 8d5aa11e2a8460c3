// Which object a pixel shows, traced on the host with the arrays of a render.
#pragma once

#include <teapath/device/scene_arrays.h>

namespace tp {

struct PickResult {
    ObjectId object;         // none: the background
    Double3 point{0, 0, 0};  // where the ray met it
};

/// What lies at (x, y) of [0, 1]^2 of the picture, (0, 0) at its top left, through the middle of
/// the lens.
PickResult pick(const SceneArrays& arrays, double x, double y);

}  // namespace tp
