// What every shape answers: where a ray meets it, what the surface is like there, and a point on
// it for light sampling.
#pragma once

#include <teapath/core/ray.h>

namespace tp {

/// The nearest meeting of a ray with a hittable so far.
struct Hit {
    Real t = kInfinity;           // distance along the unit direction
    Real u = 0, v = 0;            // coordinates inside a flat shape or triangle; else unused
    uint32_t index = 0xffffffff;  // of the hittable; kNoHit = none
    uint32_t primitive = 0;       // triangle of a mesh, else 0
};
inline constexpr uint32_t kNoHit = 0xffffffff;

/// A point of a surface, in world space.
struct SurfacePoint {
    Vec3 position;
    Vec3 normal;     // unit, geometric, the shape's own side (outwards, or by its edges)
    Vec2 uv;         // the shape's own coordinates; texture_uv makes those of images
    Real error = 0;  // bound of the position's rounding error along each axis
};

/// A direction towards a point of a shape, as seen from a reference point.
struct ShapeSample {
    SurfacePoint point;
    Vec3 direction;     // unit, from the reference point
    Real distance = 0;  // to the point
    Real pdf = 0;       // over solid angle; 0: nothing sampled
};

/// Bound of the rounding error of sums of numbers of this size.
TP_HD Real error_bound(Real magnitude) {
    return 8 * kEpsilon * magnitude;
}

/// pdf over solid angle of a point sampled with `area_pdf` over area, at `distance` in unit
/// `direction` on a surface with unit `normal`; 0 edge-on.
TP_HD Real solid_angle_pdf(Real area_pdf, Real distance, Vec3 direction, Vec3 normal) {
    const Real cosine = abs(dot(direction, normal));
    return cosine > Real(1e-7) ? area_pdf * distance * distance / cosine : 0;
}

/// The sample towards `point` as seen from `from`, given its pdf over area.
TP_HD ShapeSample sample_of_point(const SurfacePoint& point, Vec3 from, Real area_pdf) {
    const Vec3 offset = point.position - from;
    const Real distance = length(offset);
    if (!(distance > 0)) return {};
    const Vec3 direction = offset / distance;
    return {point, direction, distance,
            solid_angle_pdf(area_pdf, distance, direction, point.normal)};
}

}  // namespace tp
