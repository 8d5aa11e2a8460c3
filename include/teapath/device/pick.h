// What a ray meets first, traced on the host with the arrays of a render.
#pragma once

#include <teapath/device/scene_arrays.h>

namespace tp {

struct PickResult {
    ObjectId object;         // none: the background
    Double3 point{0, 0, 0};  // where the ray met it
};

/// What lies first along the ray; `direction` is a unit vector.
PickResult pick(const SceneArrays& arrays, const Double3& origin, const Double3& direction,
                double t_max);

}  // namespace tp
