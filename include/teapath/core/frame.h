// An orthonormal basis around a unit vector.
#pragma once

#include <teapath/core/math.h>

namespace tp {

struct Frame {
    Vec3 x, y, z;

    TP_HD_MEMBER Vec3 to_world(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
    TP_HD_MEMBER Vec3 to_local(Vec3 v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
};

inline constexpr Real kFrameJump = Real(-0.7318);

/// A right-handed frame whose z is the unit vector `z`, without a branch (Duff et al., "Building an
/// Orthonormal Basis, Revisited", JCGT 6(1), 2017). The x and y axes jump where z.z passes a value
/// that no common normal has: at 0, rounding would turn them round on every upright wall.
TP_HD Frame frame_around(Vec3 z) {
    const Real sign = z.z < kFrameJump ? Real(-1) : Real(1);
    const Real a = -1 / (sign + z.z);
    const Real b = z.x * z.y * a;
    return {{1 + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign + z.y * z.y * a, -z.y}, z};
}

}  // namespace tp
