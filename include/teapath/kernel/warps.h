// Maps from the unit square to the distributions that rendering needs, each with its density.
// Directions are unit, around +z.
#pragma once

#include <teapath/core/frame.h>
#include <teapath/core/math.h>

#include <cmath>

namespace tp {

/// Uniform in the unit disk: radius by the square root, angle by the second number. Density 1 / pi.
TP_HD Vec2 sample_uniform_disk(Vec2 u) {
    const Real r = tp::sqrt(u.x);
    Real sine, cosine;
    sincos_2pi(u.y, sine, cosine);
    return {r * cosine, r * sine};
}
TP_HD Real uniform_disk_pdf() {
    return kInvPi;
}

/// Density cos / pi over the hemisphere (Malley's method).
TP_HD Vec3 sample_cosine_hemisphere(Vec2 u) {
    const Vec2 d = sample_uniform_disk(u);
    return {d.x, d.y, safe_sqrt(1 - u.x)};
}
TP_HD Real cosine_hemisphere_pdf(Real cosine) {
    return max(cosine, Real(0)) * kInvPi;
}

/// The direction with height z and azimuth 2 pi u.
TP_HD Vec3 direction_at(Real z, Real u) {
    const Real r = safe_sqrt(1 - z * z);
    Real sine, cosine;
    sincos_2pi(u, sine, cosine);
    return {r * cosine, r * sine, z};
}

TP_HD Vec3 sample_uniform_hemisphere(Vec2 u) {
    return direction_at(u.x, u.y);
}
TP_HD Real uniform_hemisphere_pdf() {
    return kInvPi / 2;
}

TP_HD Vec3 sample_uniform_sphere(Vec2 u) {
    return direction_at(1 - 2 * u.x, u.y);
}
TP_HD Real uniform_sphere_pdf() {
    return kInvPi / 4;
}

/// Uniform over the solid angle of a cone around z; `cone` = 1 - cos of its half angle, which
/// keeps its precision where the cone is tiny.
TP_HD Vec3 sample_uniform_cone(Vec2 u, Real cone) {
    const Real depth = u.x * cone;  // 1 - cos
    const Real r = safe_sqrt(depth * (2 - depth));
    Real sine, cosine;
    sincos_2pi(u.y, sine, cosine);
    return {r * cosine, r * sine, 1 - depth};
}
TP_HD Real uniform_cone_pdf(Real cone) {
    return kInvPi / (2 * cone);
}

/// Uniform in the triangle x, y >= 0, x + y <= 1 (Heitz, "A Low-Distortion Map Between Triangle
/// and Square", 2019). Density 2.
TP_HD Vec2 sample_uniform_triangle(Vec2 u) {
    if (u.y > u.x) {
        const Real x = u.x / 2;
        return {x, u.y - x};
    }
    const Real y = u.y / 2;
    return {u.x - y, y};
}
TP_HD Real uniform_triangle_pdf() {
    return 2;
}

/// Uniform in the unit ball. Density 3 / (4 pi).
TP_HD Vec3 sample_uniform_ball(Vec2 u, Real u3) {
    return sample_uniform_sphere(u) * std::cbrt(u3);
}
TP_HD Real uniform_ball_pdf() {
    return kInvPi * Real(0.75);
}

/// The unit direction of `axis` + `radius` * (a point uniform in the unit ball): how the book's
/// fuzzy metal scatters.
TP_HD Vec3 sample_fuzz_lobe(Vec3 axis, Real radius, Vec2 u, Real u3) {
    const Vec3 d = axis + sample_uniform_ball(u, u3) * radius;
    const Real l2 = dot(d, d);
    return l2 > Real(1e-12) ? d * tp::rsqrt(l2) : axis;
}

/// Density of sample_fuzz_lobe over solid angle: the ball's density 3 / (4 pi r^3) times the
/// integral of t^2 along the ray's chord through the ball, (t1^3 - t0^3) / (4 pi r^3).
TP_HD Real fuzz_lobe_pdf(Vec3 axis, Real radius, Vec3 w) {
    const Real along = dot(axis, w);
    const Vec3 across = axis - w * along;
    const Real half_chord2 = radius * radius - dot(across, across);
    if (half_chord2 <= 0) return 0;
    const Real h = tp::sqrt(half_chord2);
    const Real t1 = along + h, t0 = max(along - h, Real(0));
    if (t1 <= 0) return 0;
    return (t1 - t0) * (t1 * t1 + t1 * t0 + t0 * t0) / (4 * kPi * radius * radius * radius);
}

}  // namespace tp
