// What the surface of a placed mesh is like at a point, and points of its triangles for light
// sampling.
#pragma once

#include <teapath/core/frame.h>
#include <teapath/kernel/mesh/mesh_view.h>
#include <teapath/kernel/shapes/surface_point.h>

namespace tp {

/// Weights of a triangle's corners.
struct Barycentric {
    Real a, b, c;
};

template <class T>
TP_HD T interpolate(const T* values, const MeshTriangle& t, Barycentric w) {
    return values[t.a.vertex] * w.a + values[t.b.vertex] * w.b + values[t.c.vertex] * w.c;
}

/// A normal of the mesh's space in the world, unit. Mirroring keeps fronts.
TP_HD Vec3 world_normal(const InstanceRecord& instance, Vec3 normal) {
    return normalize(normal * instance.object_from_world.linear);
}

/// The bound of the rounding of a position and of rays that meet it there.
TP_HD Real position_error(const InstanceRecord& instance, Vec3 p) {
    const Mat3& m = instance.world_from_object.linear;
    const Vec3 size = abs(m[0]) * abs(p.x) + abs(m[1]) * abs(p.y) + abs(m[2]) * abs(p.z) +
                      abs(instance.world_from_object.offset);
    return 2 * error_bound(max_component(size));
}

/// The point of a triangle with these weights; its uv are the weights of b and c.
TP_HD SurfacePoint mesh_point(const InstanceRecord& instance, const MeshTriangle& t,
                              Barycentric w) {
    const Vec3 edge_b = t.b.position - t.a.position, edge_c = t.c.position - t.a.position;
    const Vec3 p = t.a.position * w.a + t.b.position * w.b + t.c.position * w.c;
    const Vec3 size = max(abs(t.a.position), max(abs(t.b.position), abs(t.c.position)));
    return {instance.world_from_object.point(p),
            world_normal(instance, cross(edge_b, edge_c)),
            {w.b, w.c},
            position_error(instance, size)};
}

TP_HD Barycentric barycentric_at(Vec2 uv) {
    return {1 - uv.x - uv.y, uv.x, uv.y};
}

/// The interpolated normal in the world; the geometric one where the mesh has none.
TP_HD Vec3 shading_normal_at(const MeshView& mesh, const InstanceRecord& instance,
                             const MeshTriangle& t, const SurfacePoint& point) {
    if (!instance.smooth || !mesh.attributes.normals) return point.normal;
    const Vec3 n = interpolate(mesh.attributes.normals, t, barycentric_at(point.uv));
    return length_squared(n) > Real(1e-12) ? world_normal(instance, n) : point.normal;
}

/// What a point that lies below the tangent planes of a triangle's corners is moved by, for one
/// corner; `normal` is on the side that the surface is seen from.
TP_HD Vec3 lift_of_corner(Vec3 position, Vec3 corner, Vec3 normal) {
    return normal * -min(dot(position - corner, normal), Real(0));
}

/// The point of a triangle, moved to the surface that its normals describe (Hanika, "Hacking the
/// Shadow Terminator", Ray Tracing Gems II, 2021); `normal` is the one for shading.
TP_HD Vec3 lifted_position(const MeshView& mesh, const InstanceRecord& instance,
                           const MeshTriangle& t, Barycentric w, Vec3 position, Vec3 normal) {
    const auto lift = [&](const MeshCorner& corner) {
        const Vec3 n = mesh.attributes.normals[corner.vertex];
        if (!(length_squared(n) > Real(1e-12))) return Vec3(0, 0, 0);
        const Vec3 world = world_normal(instance, n);
        return lift_of_corner(position, instance.world_from_object.point(corner.position),
                              dot(world, normal) < 0 ? -world : world);
    };
    return position + lift(t.a) * w.a + lift(t.b) * w.b + lift(t.c) * w.c;
}

/// Texture coordinates of set 0 or 1; zero where the mesh has none.
TP_HD Vec2 mesh_uv(const MeshView& mesh, const MeshTriangle& t, Vec2 barycentric, int set) {
    const Vec2* uvs = mesh.attributes.uvs[set];
    return uvs ? interpolate(uvs, t, barycentric_at(barycentric)) : Vec2(0, 0);
}

/// The direction of growing u in the world, and the sign of the bitangent w * n x t towards the top
/// of the image: by the mesh's tangents, else by set 0 of its texture coordinates; zero without.
TP_HD Vec4 mesh_tangent(const MeshView& mesh, const InstanceRecord& instance, const MeshTriangle& t,
                        const SurfacePoint& point) {
    const Mat3& linear = instance.world_from_object.linear;
    if (mesh.attributes.tangents) {
        const Vec4 tangent = interpolate(mesh.attributes.tangents, t, barycentric_at(point.uv));
        return Vec4(linear * Vec3(tangent), tangent.w < 0 ? -1 : 1);
    }
    const Vec2* uvs = mesh.attributes.uvs[0];
    if (!uvs) return {0, 0, 0, 1};
    const Vec2 b = uvs[t.b.vertex] - uvs[t.a.vertex], c = uvs[t.c.vertex] - uvs[t.a.vertex];
    const Real determinant = b.x * c.y - c.x * b.y;
    if (determinant == 0) return {0, 0, 0, 1};
    const Vec3 edge_b = linear * (t.b.position - t.a.position);
    const Vec3 edge_c = linear * (t.c.position - t.a.position);
    const Vec3 along_u = (edge_b * c.y - edge_c * b.y) / determinant;
    const Vec3 along_v = (edge_c * b.x - edge_b * c.x) / determinant;
    return Vec4(along_u, dot(cross(point.normal, along_u), along_v) > 0 ? -1 : 1);
}

/// The area of a placed triangle.
TP_HD Real area_of(const InstanceRecord& instance, const MeshTriangle& t) {
    const Mat3& m = instance.world_from_object.linear;
    return length(cross(m * (t.b.position - t.a.position), m * (t.c.position - t.a.position))) / 2;
}

}  // namespace tp
