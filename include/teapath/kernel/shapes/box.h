// A box, rotated and scaled as one likes: the image of the cube [-1, 1]^3.
#pragma once

#include <teapath/kernel/shapes/ellipsoid.h>

namespace tp {

struct Box : UnitBody {};

TP_HD Bounds bounds_of(const Box& b) {
    const Mat3 axes = world_from_object(b);
    const Vec3 extent = abs(axes[0]) + abs(axes[1]) + abs(axes[2]);
    return {b.center - extent, b.center + extent};
}

/// Area of the two faces across axis 0, 1, 2 of the half axes `axes`.
TP_HD Vec3 face_areas(const Mat3& axes) {
    return Vec3(length(cross(axes[1], axes[2])), length(cross(axes[2], axes[0])),
                length(cross(axes[0], axes[1]))) *
           Real(4);
}
TP_HD Real area_of(const Box& b) {
    const Vec3 areas = face_areas(world_from_object(b));
    return 2 * (areas.x + areas.y + areas.z);
}

/// Slab test in object space. From outside the entry is hit, from within the exit.
TP_HD bool intersect(const Box& b, Vec3 origin, Vec3 direction, Real t_max, Hit& hit) {
    const Vec3 o = b.object_from_world * (origin - b.center);
    const Vec3 d = b.object_from_world * direction;
    Real entry = -kInfinity, exit = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
        if (d[axis] == 0) {
            if (abs(o[axis]) > 1) return false;
            continue;
        }
        const Real inverse = 1 / d[axis];
        const Real near = (-o[axis] - (inverse > 0 ? 1 : -1)) * inverse;
        const Real far = (-o[axis] + (inverse > 0 ? 1 : -1)) * inverse;
        entry = max(entry, near);
        exit = min(exit, far);
    }
    const bool outside = max_component(abs(o)) > 1;
    const Real t = outside ? entry : exit;
    if (!(entry <= exit && t > 0 && t < t_max)) return false;
    hit.t = t;
    return true;
}

/// The point at `local` on the face across `axis` of the unit cube; uv upright seen from outside.
TP_HD SurfacePoint box_point(const Box& b, int axis, Vec3 local) {
    const Mat3 axes = world_from_object(b);
    const Vec3 p = b.center + axes * local;
    const Real side = local[axis] < 0 ? Real(-1) : Real(1);
    const Vec3 row{b.object_from_world[0][axis], b.object_from_world[1][axis],
                   b.object_from_world[2][axis]};
    // u runs to the right, v down, for someone who looks at the face with y up (top: z down).
    const Real across = axis == 0 ? -side * local.z : axis == 1 ? local.x : side * local.x;
    const Real down = axis == 1 ? side * local.z : -local.y;
    return {p,
            normalize(row) * side,
            {(across + 1) / 2, (down + 1) / 2},
            error_bound(2 * (max_component(abs(p)) + 3 * max_abs(axes)))};
}

TP_HD Vec2 texture_uv(const Box&, const SurfacePoint& point) {
    return point.uv;
}

TP_HD SurfacePoint surface_at(const Box& b, Vec3 origin, Vec3 direction, const Hit& hit) {
    Vec3 local = b.object_from_world * (origin + direction * hit.t - b.center);
    const Vec3 size = abs(local);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    local[axis] = local[axis] < 0 ? Real(-1) : Real(1);  // back onto the face
    return box_point(b, axis, local);
}

/// Area of the faces that can be seen from object-space point `o`; from within all of them.
TP_HD Vec3 visible_areas(Vec3 areas, Vec3 o) {
    if (max_component(abs(o)) <= 1) return areas * Real(2);
    return {abs(o.x) > 1 ? areas.x : 0, abs(o.y) > 1 ? areas.y : 0, abs(o.z) > 1 ? areas.z : 0};
}

/// Uniform over the area of the faces that can be seen from `from`.
TP_HD ShapeSample sample_toward(const Box& b, Vec3 from, Vec2 u) {
    const Vec3 o = b.object_from_world * (from - b.center);
    const Vec3 areas = visible_areas(face_areas(world_from_object(b)), o);
    const Real total = areas.x + areas.y + areas.z;
    // u.x picks the face, and what is left of it the place within.
    Real pick = u.x * total;
    int axis = 0;
    if (pick >= areas.x) {
        pick -= areas.x;
        axis = 1;
        if (pick >= areas.y) {
            pick -= areas.y;
            axis = 2;
        }
    }
    Real rest = min(pick / areas[axis], 1 - kEpsilon);
    Real side = o[axis] < 0 ? Real(-1) : Real(1);
    if (max_component(abs(o)) <= 1) {  // from within: both faces of the axis
        side = rest < Real(0.5) ? Real(-1) : Real(1);
        rest = rest < Real(0.5) ? 2 * rest : 2 * rest - 1;
    }
    Vec3 local;
    local[axis] = side;
    local[(axis + 1) % 3] = 2 * rest - 1;
    local[(axis + 2) % 3] = 2 * u.y - 1;
    return sample_of_point(box_point(b, axis, local), from, 1 / total);
}

TP_HD Real pdf_toward(const Box& b, Vec3 from, Vec3 direction, const SurfacePoint& point,
                      Real distance) {
    const Vec3 areas =
        visible_areas(face_areas(world_from_object(b)), b.object_from_world * (from - b.center));
    return solid_angle_pdf(1 / (areas.x + areas.y + areas.z), distance, direction, point.normal);
}

}  // namespace tp
