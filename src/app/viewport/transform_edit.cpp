#include "transform_edit.h"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double kLowestScale = 1e-6;

}  // namespace

DoubleMat3 rotation_of(const Transform& t) {
    Transform unscaled = t;
    unscaled.scale = {1, 1, 1};
    return linear_part(unscaled);
}

Transform moved(const Transform& t, const Double3& by) {
    Transform result = t;
    result.translation += by;
    return result;
}

Transform turned_about(const Transform& t, const Double3& pivot, const DoubleMat3& rotation) {
    Transform result = t;
    result.rotation = euler_degrees(rotation * rotation_of(t));
    result.translation = pivot + rotation * (t.translation - pivot);
    return result;
}

Transform scaled_about(const Transform& t, const Double3& pivot, const DoubleMat3& axes,
                       const Double3& factor) {
    DoubleMat3 stretch = axes;
    for (int i = 0; i < 3; ++i)
        stretch[i] *= factor[i];
    stretch = stretch * glm::transpose(axes);
    const DoubleMat3 own = rotation_of(t);
    const bool is_uniform = factor.x == factor.y && factor.y == factor.z;
    Transform result = t;
    for (int i = 0; i < 3; ++i) {
        const double by = is_uniform ? factor.x : glm::length(stretch * own[i]);
        const double scale = t.scale[i] * by;
        result.scale[i] = std::copysign(std::max(std::abs(scale), kLowestScale), scale);
    }
    result.translation = pivot + stretch * (t.translation - pivot);
    return result;
}

}  // namespace tp
