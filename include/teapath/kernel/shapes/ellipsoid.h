// The image of the unit sphere under a linear map: a sphere that is rotated or scaled unevenly.
#pragma once

#include <teapath/kernel/shapes/sphere.h>

namespace tp {

/// A body given as the image of a unit body (ball or cube) around the origin.
struct UnitBody {
    Vec3 center;
    Mat3 object_from_world;  // linear part
};
struct Ellipsoid : UnitBody {};

/// The columns of the inverse of `m`: the body's half axes in world space.
TP_HD Mat3 world_from_object(const UnitBody& body) {
    return glm::inverse(body.object_from_world);
}

TP_HD Real max_abs(const Mat3& m) {
    return max(max_component(abs(m[0])), max(max_component(abs(m[1])), max_component(abs(m[2]))));
}

TP_HD Bounds bounds_of(const Ellipsoid& e) {
    const Mat3 axes = world_from_object(e);
    const Vec3 extent = {tp::sqrt(sqr(axes[0].x) + sqr(axes[1].x) + sqr(axes[2].x)),
                         tp::sqrt(sqr(axes[0].y) + sqr(axes[1].y) + sqr(axes[2].y)),
                         tp::sqrt(sqr(axes[0].z) + sqr(axes[1].z) + sqr(axes[2].z))};
    return {e.center - extent, e.center + extent};
}

/// Surface area by Thomsen's formula (relative error below 1.1 %); used to weigh lights only.
TP_HD Real area_of(const Ellipsoid& e) {
    const Mat3 axes = world_from_object(e);
    const Real p = Real(1.6075);
    const Real a = std::pow(length(axes[0]), p), b = std::pow(length(axes[1]), p),
               c = std::pow(length(axes[2]), p);
    return 4 * kPi * std::pow((a * b + a * c + b * c) / 3, 1 / p);
}

TP_HD bool intersect(const Ellipsoid& e, Vec3 origin, Vec3 direction, Real t_max, Hit& hit) {
    const Vec3 o = e.object_from_world * (origin - e.center);
    const Vec3 d = e.object_from_world * direction;
    const Real inverse_length = tp::rsqrt(dot(d, d));
    const Real t = sphere_distance({0, 0, 0}, 1, o, d * inverse_length) * inverse_length;
    if (!(t > 0 && t < t_max)) return false;
    hit.t = t;
    return true;
}

/// The point whose unit direction in object space is `local`.
TP_HD SurfacePoint surface_point(const Ellipsoid& e, Vec3 local) {
    const Mat3 axes = world_from_object(e);
    const Vec3 p = e.center + axes * local;
    const Vec3 normal = normalize(glm::transpose(e.object_from_world) * local);
    return {p, normal, {0, 0}, error_bound(2 * (max_component(abs(p)) + 3 * max_abs(axes)))};
}

TP_HD Vec2 texture_uv(const Ellipsoid& e, const SurfacePoint& point) {
    return sphere_uv(normalize(e.object_from_world * (point.position - e.center)));
}

TP_HD SurfacePoint surface_at(const Ellipsoid& e, Vec3 origin, Vec3 direction, const Hit& hit) {
    return surface_point(e,
                         normalize(e.object_from_world * (origin + direction * hit.t - e.center)));
}

/// How solid angle grows from object to world directions around the world direction `d`: the pdf
/// of a world direction is the object's pdf times |det A| / |A d|^3, A = object_from_world.
TP_HD Real direction_jacobian(const Ellipsoid& e, Vec3 d) {
    const Real l2 = length_squared(e.object_from_world * d);
    return abs(glm::determinant(e.object_from_world)) / (l2 * tp::sqrt(l2));
}

/// Samples the cone of the unit sphere in object space, where it is exact, and maps the direction.
TP_HD ShapeSample sample_toward(const Ellipsoid& e, Vec3 from, Vec2 u) {
    const Sphere unit{{0, 0, 0}, 1};
    const ShapeSample local = sample_toward(unit, e.object_from_world * (from - e.center), u);
    if (!(local.pdf > 0)) return {};
    ShapeSample sample;
    sample.point = surface_point(e, local.point.normal);
    const Vec3 offset = world_from_object(e) * (local.direction * local.distance);
    sample.distance = length(offset);
    sample.direction = offset / sample.distance;
    sample.pdf = local.pdf * direction_jacobian(e, sample.direction);
    return sample;
}

TP_HD Real pdf_toward(const Ellipsoid& e, Vec3 from, Vec3 direction, const SurfacePoint& point,
                      Real distance) {
    const Vec3 local = e.object_from_world * direction;
    const Real stretch = length(local);
    SurfacePoint local_point;
    local_point.normal = normalize(e.object_from_world * (point.position - e.center));
    const Real pdf = pdf_toward(Sphere{{0, 0, 0}, 1}, e.object_from_world * (from - e.center),
                                local / stretch, local_point, distance * stretch);
    return pdf * direction_jacobian(e, direction);
}

}  // namespace tp
