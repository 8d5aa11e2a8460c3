// Flat shapes: parallelogram, ellipse (the image of a disk) and triangle share one plane
// intersection and differ in which of its coordinates lie inside.
#pragma once

#include <teapath/core/bounds.h>
#include <teapath/kernel/shapes/surface_point.h>
#include <teapath/kernel/warps.h>

namespace tp {

/// A point p of the plane is origin + u * edge_u + v * edge_v; the normal is along edge_u x edge_v.
struct Flat {
    Vec3 corner;  // of a disk: the centre
    Vec3 edge_u;
    Vec3 edge_v;
};
struct Rectangle : Flat {};  // 0 <= u, v <= 1
struct Disk : Flat {};       // u^2 + v^2 <= 1
struct Triangle : Flat {};   // 0 <= u, v and u + v <= 1

TP_HD bool is_inside(const Rectangle&, Real u, Real v) {
    return u >= 0 && u <= 1 && v >= 0 && v <= 1;
}
TP_HD bool is_inside(const Disk&, Real u, Real v) {
    return u * u + v * v <= 1;
}
TP_HD bool is_inside(const Triangle&, Real u, Real v) {
    return u >= 0 && v >= 0 && u + v <= 1;
}

TP_HD Bounds bounds_of(const Rectangle& r) {
    const Bounds b = join(Bounds{r.corner, r.corner}, r.corner + r.edge_u);
    return join(join(b, r.corner + r.edge_v), r.corner + r.edge_u + r.edge_v);
}
TP_HD Bounds bounds_of(const Triangle& t) {
    return join(join(Bounds{t.corner, t.corner}, t.corner + t.edge_u), t.corner + t.edge_v);
}
TP_HD Bounds bounds_of(const Disk& d) {
    const Vec3 extent{tp::sqrt(sqr(d.edge_u.x) + sqr(d.edge_v.x)),
                      tp::sqrt(sqr(d.edge_u.y) + sqr(d.edge_v.y)),
                      tp::sqrt(sqr(d.edge_u.z) + sqr(d.edge_v.z))};
    return {d.corner - extent, d.corner + extent};
}

TP_HD Real area_of(const Rectangle& r) {
    return length(cross(r.edge_u, r.edge_v));
}
TP_HD Real area_of(const Triangle& t) {
    return length(cross(t.edge_u, t.edge_v)) / 2;
}
TP_HD Real area_of(const Disk& d) {
    return length(cross(d.edge_u, d.edge_v)) * kPi;
}

/// Where a ray meets the plane, in its own coordinates: the equations of Moller and Trumbore,
/// "Fast, Minimum Storage Ray/Triangle Intersection", 1997. A ray within the plane never hits.
template <class Shape>
TP_HD bool intersect_flat(const Shape& s, Vec3 origin, Vec3 direction, Real t_max, Hit& hit) {
    const Vec3 p = cross(direction, s.edge_v);
    const Real determinant = dot(s.edge_u, p);
    if (determinant == 0) return false;
    const Real inverse = 1 / determinant;
    const Vec3 from_corner = origin - s.corner;
    const Real u = dot(from_corner, p) * inverse;
    const Vec3 q = cross(from_corner, s.edge_u);
    const Real v = dot(direction, q) * inverse;
    const Real t = dot(s.edge_v, q) * inverse;
    if (!(t > 0 && t < t_max && is_inside(s, u, v))) return false;
    hit.t = t;
    hit.u = u;
    hit.v = v;
    return true;
}
TP_HD bool intersect(const Rectangle& s, Vec3 o, Vec3 d, Real t_max, Hit& hit) {
    return intersect_flat(s, o, d, t_max, hit);
}
TP_HD bool intersect(const Disk& s, Vec3 o, Vec3 d, Real t_max, Hit& hit) {
    return intersect_flat(s, o, d, t_max, hit);
}
TP_HD bool intersect(const Triangle& s, Vec3 o, Vec3 d, Real t_max, Hit& hit) {
    return intersect_flat(s, o, d, t_max, hit);
}

TP_HD SurfacePoint flat_point(const Flat& s, Real u, Real v) {
    const Vec3 along_u = s.edge_u * u, along_v = s.edge_v * v;
    const Vec3 p = s.corner + along_u + along_v;
    const Real size =
        max_component(abs(s.corner)) + max_component(abs(s.edge_u)) + max_component(abs(s.edge_v));
    return {p, normalize(cross(s.edge_u, s.edge_v)), {u, v}, error_bound(size)};
}

TP_HD Vec2 texture_uv(const Flat&, const SurfacePoint& point) {
    return point.uv;
}

/// A disk's u is the angle from edge_u, counter-clockwise, v the distance from the centre.
TP_HD Vec2 texture_uv(const Disk&, const SurfacePoint& point) {
    const Real angle = std::atan2(point.uv.y, point.uv.x) * (kInvPi / 2);
    return {angle < 0 ? angle + 1 : angle, tp::sqrt(dot(point.uv, point.uv))};
}

TP_HD SurfacePoint surface_at(const Flat& s, Vec3, Vec3, const Hit& hit) {
    return flat_point(s, hit.u, hit.v);
}

// Points uniform over the area; pdf over solid angle as seen from `from`.

TP_HD ShapeSample sample_toward(const Rectangle& s, Vec3 from, Vec2 u) {
    return sample_of_point(flat_point(s, u.x, u.y), from, 1 / area_of(s));
}
TP_HD ShapeSample sample_toward(const Disk& s, Vec3 from, Vec2 u) {
    const Vec2 p = sample_uniform_disk(u);
    return sample_of_point(flat_point(s, p.x, p.y), from, 1 / area_of(s));
}
TP_HD ShapeSample sample_toward(const Triangle& s, Vec3 from, Vec2 u) {
    const Vec2 p = sample_uniform_triangle(u);
    return sample_of_point(flat_point(s, p.x, p.y), from, 1 / area_of(s));
}

TP_HD Real pdf_toward(const Rectangle& s, Vec3, Vec3 direction, const SurfacePoint& point,
                      Real distance) {
    return solid_angle_pdf(1 / area_of(s), distance, direction, point.normal);
}
TP_HD Real pdf_toward(const Disk& s, Vec3, Vec3 direction, const SurfacePoint& point,
                      Real distance) {
    return solid_angle_pdf(1 / area_of(s), distance, direction, point.normal);
}
TP_HD Real pdf_toward(const Triangle& s, Vec3, Vec3 direction, const SurfacePoint& point,
                      Real distance) {
    return solid_angle_pdf(1 / area_of(s), distance, direction, point.normal);
}

}  // namespace tp
