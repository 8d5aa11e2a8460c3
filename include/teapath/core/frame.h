// An orthonormal basis around a unit vector.
#pragma once

#include <teapath/core/math.h>

namespace tp {

struct Frame {
    Vec3 x, y, z;

    TP_HD_MEMBER Vec3 to_world(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
    TP_HD_MEMBER Vec3 to_local(Vec3 v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
};

/// A right-handed frame whose z is the unit vector `z`, without a branch
/// (Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017).
TP_HD Frame frame_around(Vec3 z) {
    const Real sign = z.z < 0 ? Real(-1) : Real(1);
    const Real a = -1 / (sign + z.z);
    const Real b = z.x * z.y * a;
    return {{1 + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign + z.y * z.y * a, -z.y}, z};
}

}  // namespace tp
