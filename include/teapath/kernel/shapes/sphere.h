// A sphere without rotation or uneven scale: the shape of most scenes, and the cheapest.
#pragma once

#include <teapath/core/bounds.h>
#include <teapath/core/frame.h>
#include <teapath/kernel/shapes/surface_point.h>
#include <teapath/kernel/warps.h>

namespace tp {

struct Sphere {
    Vec3 center;
    Real radius;  // above 0; an inward normal is a flag of the hittable
};

TP_HD Bounds bounds_of(const Sphere& s) {
    const Vec3 r{s.radius, s.radius, s.radius};
    return {s.center - r, s.center + r};
}

TP_HD Real area_of(const Sphere& s) {
    return 4 * kPi * s.radius * s.radius;
}

/// Distance to the nearest crossing beyond the origin, or a negative number. The discriminant is
/// taken from the part of the offset across the ray (Hearn and Baker; Haines et al., "Precision
/// Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019); which side the origin is on
/// decides the root, so that an origin moved off the surface never meets it again.
TP_HD Real sphere_distance(Vec3 center, Real radius, Vec3 origin, Vec3 direction) {
    const Vec3 to_center = center - origin;
    const Real along = dot(to_center, direction);
    const Vec3 across = to_center - direction * along;
    const Real discriminant = radius * radius - dot(across, across);
    const Real outside = dot(to_center, to_center) - radius * radius;
    if (!(discriminant > 0) || (outside > 0 && along <= 0)) return -1;
    const Real root = tp::sqrt(discriminant);
    if (outside > 0) return outside / (along + root);
    return along > 0 ? along + root : outside / (along - root);
}

TP_HD bool intersect(const Sphere& s, Vec3 origin, Vec3 direction, Real t_max, Hit& hit) {
    const Real t = sphere_distance(s.center, s.radius, origin, direction);
    if (!(t > 0 && t < t_max)) return false;
    hit.t = t;
    return true;
}

/// Longitude and colatitude of a unit vector: u eastwards, 0 to 1; v from the north pole down.
TP_HD Vec2 sphere_uv(Vec3 n) {
    return {(std::atan2(-n.z, n.x) + kPi) * (kInvPi / 2),
            std::acos(clamp(n.y, Real(-1), Real(1))) * kInvPi};
}

TP_HD Vec2 texture_uv(const Sphere& s, const SurfacePoint& point) {
    return sphere_uv((point.position - s.center) / s.radius);
}

TP_HD SurfacePoint surface_point(const Sphere& s, Vec3 normal) {
    const Vec3 p = s.center + normal * s.radius;
    return {p, normal, {0, 0}, error_bound(max_component(abs(p)) + s.radius)};
}

TP_HD SurfacePoint surface_at(const Sphere& s, Vec3 origin, Vec3 direction, const Hit& hit) {
    return surface_point(s, normalize(origin + direction * hit.t - s.center));
}

/// The share 1 - cos of the cone that the sphere fills as seen from distance^2 = `d2` outside.
TP_HD Real sphere_cone(const Sphere& s, Real d2) {
    const Real sin2 = s.radius * s.radius / d2;
    return sin2 / (1 + safe_sqrt(1 - sin2));
}

/// Uniform in the cone of visible directions from outside, uniform over the area from within.
TP_HD ShapeSample sample_toward(const Sphere& s, Vec3 from, Vec2 u) {
    const Vec3 to_center = s.center - from;
    const Real d2 = length_squared(to_center);
    if (d2 <= s.radius * s.radius * (1 + 16 * kEpsilon)) {
        return sample_of_point(surface_point(s, sample_uniform_sphere(u)), from, 1 / area_of(s));
    }
    const Real cone = sphere_cone(s, d2);
    const Frame frame = frame_around(normalize(to_center));
    const Vec3 direction = frame.to_world(sample_uniform_cone(u, cone));
    // The near crossing; at the rim rounding may miss the sphere, then the point of tangency
    // serves.
    const Real along = dot(to_center, direction);
    const Vec3 across = to_center - direction * along;
    const Real distance = along - safe_sqrt(s.radius * s.radius - dot(across, across));
    const Vec3 normal = normalize(direction * distance - to_center);
    return {surface_point(s, normal), direction, distance, uniform_cone_pdf(cone)};
}

/// pdf over solid angle of sample_toward giving the direction that met the sphere at `hit`.
TP_HD Real pdf_toward(const Sphere& s, Vec3 from, Vec3 direction, const SurfacePoint& point,
                      Real distance) {
    const Real d2 = length_squared(s.center - from);
    if (d2 <= s.radius * s.radius * (1 + 16 * kEpsilon))
        return solid_angle_pdf(1 / area_of(s), distance, direction, point.normal);
    return uniform_cone_pdf(sphere_cone(s, d2));
}

}  // namespace tp
