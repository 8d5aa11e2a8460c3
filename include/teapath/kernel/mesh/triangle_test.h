// A ray against a triangle, watertight: a ray that passes an edge or corner shared by triangles of
// a mesh meets at least one of them (Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection",
// JCGT 2(1), 2013). The ray is sheared onto its longest axis; the edge functions then are products
// whose order rounding cannot turn round, and a zero among them is decided in double.
#pragma once

#include <teapath/kernel/mesh/mesh_view.h>
#include <teapath/kernel/shapes/surface_point.h>

namespace tp {

/// A ray in the space of a mesh, prepared for many triangles.
struct ShearedRay {
    Vec3 origin;
    int axis;    // of the direction's largest component
    Vec3 shear;  // x, y: direction's other components over the largest; z: 1 / largest
};

/// The components of `v` from the one after `axis` on; the last is that of `axis`.
TP_HD Vec3 rotated_to_last(Vec3 v, int axis) {
    if (axis == 0) return {v.y, v.z, v.x};
    return axis == 1 ? Vec3(v.z, v.x, v.y) : v;
}

TP_HD ShearedRay make_sheared_ray(Vec3 origin, Vec3 direction) {
    const Vec3 size = abs(direction);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const Vec3 d = rotated_to_last(direction, axis);
    const Real inverse = 1 / d.z;
    return {origin, axis, {d.x * inverse, d.y * inverse, inverse}};
}

/// a b - c d whose sign is never wrong, though it may be zero: neither product is fused.
TP_HD Real edge_function(Real a, Real b, Real c, Real d) {
    return multiply_exactly_rounded(a, b) - multiply_exactly_rounded(c, d);
}
/// The same where it was zero.
TP_HD Real edge_function_in_double(Real a, Real b, Real c, Real d) {
    return static_cast<Real>(static_cast<double>(a) * static_cast<double>(b) -
                             static_cast<double>(c) * static_cast<double>(d));
}

/// Fills t, u, v of `hit` where the triangle is met at 0 < t < hit.t; u and v are the weights of
/// the corners b and c, t is in lengths of the direction.
TP_HD bool intersect_triangle(const MeshTriangle& triangle, const ShearedRay& ray, Hit& hit) {
    const Vec3 a = rotated_to_last(triangle.a.position - ray.origin, ray.axis);
    const Vec3 b = rotated_to_last(triangle.b.position - ray.origin, ray.axis);
    const Vec3 c = rotated_to_last(triangle.c.position - ray.origin, ray.axis);
    const Real ax = a.x - ray.shear.x * a.z, ay = a.y - ray.shear.y * a.z;
    const Real bx = b.x - ray.shear.x * b.z, by = b.y - ray.shear.y * b.z;
    const Real cx = c.x - ray.shear.x * c.z, cy = c.y - ray.shear.y * c.z;
    Real u = edge_function(cx, by, cy, bx);
    Real v = edge_function(ax, cy, ay, cx);
    Real w = edge_function(bx, ay, by, ax);
    if (u == 0 || v == 0 || w == 0) {
        u = edge_function_in_double(cx, by, cy, bx);
        v = edge_function_in_double(ax, cy, ay, cx);
        w = edge_function_in_double(bx, ay, by, ax);
    }
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
    const Real determinant = u + v + w;
    if (determinant == 0) return false;
    const Real inverse = 1 / determinant;
    const Real t = (u * a.z + v * b.z + w * c.z) * ray.shear.z * inverse;
    if (!(t > 0 && t < hit.t)) return false;
    hit.t = t;
    hit.u = v * inverse;
    hit.v = w * inverse;
    return true;
}

}  // namespace tp
