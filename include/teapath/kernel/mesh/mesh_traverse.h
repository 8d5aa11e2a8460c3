// A ray against a placed mesh: the ray goes into the mesh's space, without being made unit length
// again, so that distances stay the world's.
#pragma once

#include <teapath/kernel/mesh/triangle_test.h>

namespace tp {

/// Keeps the nearest triangle within hit.t in t, u, v and primitive of `hit`, with kAny the first
/// that is found. `ignored` is a triangle to pass over, kNoHit for none. Returns whether one was
/// met.
template <bool kAny>
TP_HD bool intersect_mesh(const MeshView& mesh, const Affine& object_from_world, Vec3 origin,
                          Vec3 direction, uint32_t ignored, Hit& hit) {
    const Vec3 o = object_from_world.point(origin);
    const Vec3 d = object_from_world.linear * direction;
    const ShearedRay ray = make_sheared_ray(o, d);
    bool met = false;
    visit_leaves(mesh.nodes, o, safe_inverse(d), hit.t, [&](uint32_t first, uint32_t last) {
        for (uint32_t i = first; i < last; ++i) {
            if (i == ignored || !intersect_triangle(mesh.triangles[i], ray, hit)) continue;
            hit.primitive = i;
            met = true;
            if (kAny) return true;
        }
        return false;
    });
    return met;
}

}  // namespace tp
