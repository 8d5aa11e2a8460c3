// Rays against the whole scene: the nearest hit, and any hit, by the tree over the hittables and
// that of each mesh.
#pragma once

#include <teapath/kernel/mesh/mesh_traverse.h>
#include <teapath/kernel/scene_view.h>

namespace tp {

/// Distances at which the ray enters and leaves a box; it is met where entry <= exit.
TP_HD void clip_box(const Bounds& b, Vec3 origin, Vec3 inverse, Real& entry, Real& exit) {
    for (int axis = 0; axis < 3; ++axis) {
        const Real low = (b.low[axis] - origin[axis]) * inverse[axis];
        const Real high = (b.high[axis] - origin[axis]) * inverse[axis];
        entry = max(entry, min(low, high));
        exit = min(exit, max(low, high));
    }
}

/// What a query passes over: a hittable, of a mesh one triangle (kNoHit for none), and what is
/// hidden from rays of this kind.
struct Ignored {
    uint32_t hittable = kNoHit;
    uint32_t primitive = kNoHit;
    uint8_t ray = 0;  // a RayKind
};

template <uint32_t kFeatures, bool kAny>
TP_HD bool intersect_one(const SceneView& scene, uint32_t i, Vec3 origin, Vec3 direction,
                         const Ignored& ignored, Hit& hit) {
    const Hittable& h = scene.hittables[i];
    if constexpr ((kFeatures & kFeatureHiding) != 0) {
        if ((h.hidden_from & ignored.ray) != 0) return false;
    }
    bool met;
    if constexpr ((kFeatures & kFeatureMeshes) != 0) {
        if (h.kind == HittableKind::Mesh) {
            const InstanceRecord& instance = scene.instances[h.mesh.instance];
            met = intersect_mesh<kAny>(scene.meshes[instance.mesh], instance.object_from_world,
                                       origin, direction,
                                       i == ignored.hittable ? ignored.primitive : kNoHit, hit);
            if (met) hit.index = i;
            return met;
        }
    }
    if (i == ignored.hittable) return false;
    if constexpr ((kFeatures & kFeatureShapes) != 0)
        met = intersect(h, origin, direction, hit.t, hit);
    else
        met = intersect(h.sphere, origin, direction, hit.t, hit);
    if (met) {
        hit.index = i;
        hit.primitive = 0;
    }
    return met;
}

/// Visits what the ray may meet within hit.t, near boxes first, and keeps the nearest hit; with
/// kAny it stops at the first.
template <uint32_t kFeatures, bool kAny>
TP_HD bool traverse(const SceneView& scene, Vec3 origin, Vec3 direction, const Ignored& ignored,
                    Hit& hit) {
    const auto test = [&](uint32_t first, uint32_t last) {
        for (uint32_t i = first; i < last; ++i) {
            if (intersect_one<kFeatures, kAny>(scene, i, origin, direction, ignored, hit) && kAny)
                return true;
        }
        return false;
    };
    if (scene.nodes.empty() || ((kFeatures & kFeatureDebug) && scene.brute_force))
        test(0, scene.hittables.size);
    else
        visit_leaves(scene.nodes, origin, safe_inverse(direction), hit.t, test);
    return hit.index != kNoHit;
}

/// The nearest hit with 0 < t < t_max; index kNoHit if there is none.
template <uint32_t kFeatures>
TP_HD Hit intersect_scene(const SceneView& scene, Vec3 origin, Vec3 direction, Real t_max,
                          uint8_t ray = kRayCamera) {
    Hit hit;
    hit.t = t_max;
    traverse<kFeatures, false>(scene, origin, direction, {kNoHit, kNoHit, ray}, hit);
    return hit;
}

/// True if anything but `ignored` lies on the segment.
template <uint32_t kFeatures>
TP_HD bool is_blocked(const SceneView& scene, Vec3 origin, Vec3 direction, Real t_max,
                      const Ignored& ignored) {
    Hit hit;
    hit.t = t_max;
    return traverse<kFeatures, true>(scene, origin, direction, ignored, hit);
}

}  // namespace tp
