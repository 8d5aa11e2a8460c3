// Rays against the whole scene: the nearest hit, and any hit, by a stack over the binary tree. The
// stack is bounded by construction (kMaxTreeDepth).
#pragma once

#include <teapath/kernel/scene_view.h>

namespace tp {

/// 1 / d with zeros replaced by something tiny, so that the slab tests meet no NaN.
TP_HD Real safe_inverse(Real d) {
    const Real tiny = Real(1e-18);
    return 1 / (abs(d) < tiny ? (d < 0 ? -tiny : tiny) : d);
}
TP_HD Vec3 safe_inverse(Vec3 d) {
    return {safe_inverse(d.x), safe_inverse(d.y), safe_inverse(d.z)};
}

/// One axis of a slab test: narrows [entry, exit] of both children.
TP_HD void clip_slab(const Real4& planes, Real origin, Real inverse, Real& entry0, Real& exit0,
                     Real& entry1, Real& exit1) {
    const Real low0 = (planes.x - origin) * inverse, high0 = (planes.y - origin) * inverse;
    const Real low1 = (planes.z - origin) * inverse, high1 = (planes.w - origin) * inverse;
    entry0 = max(entry0, min(low0, high0));
    exit0 = min(exit0, max(low0, high0));
    entry1 = max(entry1, min(low1, high1));
    exit1 = min(exit1, max(low1, high1));
}

/// Distances at which the ray enters and leaves a box; it is met where entry <= exit.
TP_HD void clip_box(const Bounds& b, Vec3 origin, Vec3 inverse, Real& entry, Real& exit) {
    for (int axis = 0; axis < 3; ++axis) {
        const Real low = (b.low[axis] - origin[axis]) * inverse[axis];
        const Real high = (b.high[axis] - origin[axis]) * inverse[axis];
        entry = max(entry, min(low, high));
        exit = min(exit, max(low, high));
    }
}

/// What rounding may do to a slab test's exit (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013).
inline constexpr Real kSlabGrowth = 1 + 8 * kEpsilon;

template <uint32_t kFeatures>
TP_HD bool intersect_one(const SceneView& scene, uint32_t i, Vec3 origin, Vec3 direction,
                         Hit& hit) {
    const Hittable& h = scene.hittables[i];
    bool met;
    if constexpr ((kFeatures & kFeatureShapes) != 0)
        met = intersect(h, origin, direction, hit.t, hit);
    else
        met = intersect(h.sphere, origin, direction, hit.t, hit);
    if (met) hit.index = i;
    return met;
}

/// Visits what the ray may meet within hit.t, near boxes first, and keeps the nearest hit; with
/// kAny it stops at the first. `ignored` is a hittable to pass over, kNoHit for none.
template <uint32_t kFeatures, bool kAny>
TP_HD bool traverse(const SceneView& scene, Vec3 origin, Vec3 direction, uint32_t ignored,
                    Hit& hit) {
    if (scene.nodes.empty() || ((kFeatures & kFeatureDebug) && scene.brute_force)) {
        for (uint32_t i = 0; i < scene.hittables.size; ++i) {
            if (i != ignored && intersect_one<kFeatures>(scene, i, origin, direction, hit) && kAny)
                return true;
        }
        return hit.index != kNoHit;
    }
    const Vec3 inverse = safe_inverse(direction);
    uint32_t stack[kMaxTreeDepth];
    int top = 0;
    uint32_t current = 0;
    for (;;) {
        while (!(current & kLeafBit)) {
            const BvhNode& node = scene.nodes[current];
            Real entry0 = 0, exit0 = hit.t, entry1 = 0, exit1 = hit.t;
            clip_slab(node.x, origin.x, inverse.x, entry0, exit0, entry1, exit1);
            clip_slab(node.y, origin.y, inverse.y, entry0, exit0, entry1, exit1);
            clip_slab(node.z, origin.z, inverse.z, entry0, exit0, entry1, exit1);
            const bool met0 = entry0 <= exit0 * kSlabGrowth, met1 = entry1 <= exit1 * kSlabGrowth;
            if (met0 && met1) {
                const bool swap = entry1 < entry0;
                TP_ASSERT(top < kMaxTreeDepth);
                stack[top++] = swap ? node.child[0] : node.child[1];
                current = swap ? node.child[1] : node.child[0];
            } else if (met0 || met1) {
                current = met0 ? node.child[0] : node.child[1];
            } else {
                if (top == 0) return hit.index != kNoHit;
                current = stack[--top];
            }
        }
        const uint32_t first = (current & ~kLeafBit) >> kLeafCountBits;
        const uint32_t count = (current & (kMaxLeafSize - 1)) + 1;
        for (uint32_t i = first; i < first + count; ++i) {
            if (i != ignored && intersect_one<kFeatures>(scene, i, origin, direction, hit) && kAny)
                return true;
        }
        if (top == 0) return hit.index != kNoHit;
        current = stack[--top];
    }
}

/// The nearest hit with 0 < t < t_max; index kNoHit if there is none.
template <uint32_t kFeatures>
TP_HD Hit intersect_scene(const SceneView& scene, Vec3 origin, Vec3 direction, Real t_max) {
    Hit hit;
    hit.t = t_max;
    traverse<kFeatures, false>(scene, origin, direction, kNoHit, hit);
    return hit;
}

/// True if anything but hittable `ignored` lies on the segment.
template <uint32_t kFeatures>
TP_HD bool is_blocked(const SceneView& scene, Vec3 origin, Vec3 direction, Real t_max,
                      uint32_t ignored) {
    Hit hit;
    hit.t = t_max;
    return traverse<kFeatures, true>(scene, origin, direction, ignored, hit);
}

}  // namespace tp
