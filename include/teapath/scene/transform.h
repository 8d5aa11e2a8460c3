// Placement of an object: scale, then rotation, then translation.
#pragma once

#include <teapath/core/math.h>

namespace tp {

struct Transform {
    Double3 translation{0, 0, 0};  // scene units
    Double3 rotation{0, 0, 0};     // degrees about x, then y, then z of the world
    Double3 scale{1, 1, 1};        // along the object's own axes; 0 is refused, negative mirrors

    friend bool operator==(const Transform&, const Transform&) = default;
};

/// The linear part: rotation times scale.
DoubleMat3 linear_part(const Transform& t);

/// The whole map from object to world space.
DoubleMat4 world_from_object(const Transform& t);

}  // namespace tp
