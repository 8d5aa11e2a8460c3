// Placement of an object: scale, then rotation, then translation.
#pragma once

#include <teapath/core/math.h>

#include <optional>

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

/// Degrees about x, then y, then z of the world, of a rotation matrix: what Transform::rotation
/// holds. At the poles the turn about z is 0.
Double3 euler_degrees(const DoubleMat3& rotation);

/// A matrix as a Transform after what a Transform cannot say.
struct SplitTransform {
    Transform transform;
    DoubleMat3 placement{1};  // shear; the identity where there is none
};

/// Splits an affine matrix: world_from_object(transform) * placement, the latter upper triangular
/// with ones on its diagonal. None for a matrix that is not finite or has an axis without length.
std::optional<SplitTransform> split_transform(const DoubleMat4& matrix);

}  // namespace tp
