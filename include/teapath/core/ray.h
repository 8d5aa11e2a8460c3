// A ray: origin, unit direction, the time that it carries and how far it may go.
#pragma once

#include <teapath/core/math.h>

namespace tp {

struct Ray {
    Vec3 origin;
    Vec3 direction;  // unit length
    Real time = 0;   // in [0, 1] over the shutter's opening
    Real t_max = kInfinity;

    TP_HD_MEMBER Vec3 at(Real t) const { return origin + direction * t; }
};

/// A start for a new ray at surface point `p`, known up to `error` (absolute, each axis), moved
/// along the unit normal `ng` to the side that `direction` leaves to, far enough that the surface
/// itself is not hit again (Pharr, Jakob, Humphreys, "Physically Based Rendering", 6.8.6).
TP_HD Vec3 offset_ray_origin(Vec3 p, Real error, Vec3 ng, Vec3 direction) {
    const Real distance = error * (abs(ng.x) + abs(ng.y) + abs(ng.z));
    return p + ng * (dot(direction, ng) > 0 ? distance : -distance);
}

}  // namespace tp
