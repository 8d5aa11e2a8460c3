// How texture coordinates change along a surface: the derivatives of texture_uv of each shape, and
// of the texture coordinates of a mesh, by the place in the world.
#pragma once

#include <teapath/kernel/material.h>

namespace tp {

/// Gradients of u and v of set 0 and 1, along the surface, per scene unit.
struct UvGradients {
    Vec3 u{0, 0, 0}, v{0, 0, 0};
    Vec3 u1{0, 0, 0}, v1{0, 0, 0};
};

/// The gradients of the coordinates of a plane along these edges.
struct EdgeGradients {
    Vec3 u{0, 0, 0}, v{0, 0, 0};
};
TP_HD EdgeGradients edge_gradients(Vec3 edge_u, Vec3 edge_v) {
    const Vec3 normal = cross(edge_u, edge_v);
    const Real l2 = length_squared(normal);
    if (!(l2 > 0)) return {};
    return {cross(edge_v, normal) / l2, cross(normal, edge_u) / l2};
}

/// The gradients of sphere_uv at unit vector `n` on the unit sphere; bounded at the poles.
TP_HD EdgeGradients sphere_gradients(Vec3 n) {
    const Real rho2 = max(n.x * n.x + n.z * n.z, Real(1e-6));
    const Vec3 up = Vec3(0, 1, 0) - n * n.y;
    return {Vec3(n.z, 0, -n.x) * (kInvPi / (2 * rho2)), up * (-kInvPi * tp::rsqrt(rho2))};
}

TP_HD EdgeGradients disk_gradients(const Disk& d, Vec2 local) {
    const EdgeGradients edges = edge_gradients(d.edge_u, d.edge_v);
    const Real r2 = max(dot(local, local), Real(1e-6));
    const Real around = kInvPi / (2 * r2), outwards = tp::rsqrt(r2);
    return {(edges.v * local.x - edges.u * local.y) * around,
            (edges.u * local.x + edges.v * local.y) * outwards};
}

TP_HD EdgeGradients box_gradients(const Box& b, Vec3 position) {
    const Vec3 local = b.object_from_world * (position - b.center);
    const Vec3 size = abs(local);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const Real side = local[axis] < 0 ? Real(-1) : Real(1);
    // As in box_point: u to the right and v down as seen from outside.
    const Vec3 across = axis == 0   ? Vec3(0, 0, -side)
                        : axis == 1 ? Vec3(1, 0, 0)
                                    : Vec3(side, 0, 0);
    const Vec3 down = axis == 1 ? Vec3(0, 0, side) : Vec3(0, -1, 0);
    return {across * b.object_from_world * Real(0.5), down * b.object_from_world * Real(0.5)};
}

TP_HD EdgeGradients shape_gradients(const Hittable& h, const SurfacePoint& point) {
    switch (h.kind) {
        case HittableKind::Rectangle:
        case HittableKind::Triangle: return edge_gradients(h.rectangle.edge_u, h.rectangle.edge_v);
        case HittableKind::Disk: return disk_gradients(h.disk, point.uv);
        case HittableKind::Box: return box_gradients(h.box, point.position);
        case HittableKind::Ellipsoid: {
            const Mat3& m = h.ellipsoid.object_from_world;
            const EdgeGradients g =
                sphere_gradients(normalize(m * (point.position - h.ellipsoid.center)));
            return {g.u * m, g.v * m};
        }
        case HittableKind::Mesh:
        case HittableKind::Sphere: break;
    }
    const Sphere& s = h.sphere;
    const EdgeGradients g = sphere_gradients((point.position - s.center) / s.radius);
    return {g.u / s.radius, g.v / s.radius};
}

/// The gradients where `s` is, which must know its hittable.
TP_HD UvGradients uv_gradients(const SceneView& scene, const Surface& s) {
    UvGradients gradients;
    const Hittable& h = scene.hittables[s.hittable];
    if (h.kind != HittableKind::Mesh) {
        const EdgeGradients g = shape_gradients(h, s.point);
        gradients.u = g.u;
        gradients.v = g.v;
        return gradients;
    }
    const InstanceRecord& instance = scene.instances[h.mesh.instance];
    const MeshView& mesh = scene.meshes[instance.mesh];
    const MeshTriangle& t = mesh.triangles[s.primitive];
    const Mat3& linear = instance.world_from_object.linear;
    const EdgeGradients g = edge_gradients(linear * (t.b.position - t.a.position),
                                           linear * (t.c.position - t.a.position));
    for (int set = 0; set < kUvSets; ++set) {
        const Vec2* uvs = mesh.attributes.uvs[set];
        if (!uvs) continue;
        const Vec2 b = uvs[t.b.vertex] - uvs[t.a.vertex], c = uvs[t.c.vertex] - uvs[t.a.vertex];
        (set == 0 ? gradients.u : gradients.u1) = g.u * b.x + g.v * c.x;
        (set == 0 ? gradients.v : gradients.v1) = g.u * b.y + g.v * c.y;
    }
    return gradients;
}

}  // namespace tp
