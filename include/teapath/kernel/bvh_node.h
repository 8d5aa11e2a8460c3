// The two-wide tree and the walk through it, whatever its leaves hold: hittables at the top,
// triangles in a mesh. The stack is bounded by construction (kMaxTreeDepth).
#pragma once

#include <teapath/core/bounds.h>
#include <teapath/core/span.h>

namespace tp {

/// Four numbers that are loaded at once.
struct alignas(16) Real4 {
    Real x, y, z, w;
};

/// Two children of the tree with their boxes, 64 bytes: per axis low and high of child 0, low and
/// high of child 1. A child is a node's index, or a leaf: bit 31, first item, count - 1.
struct alignas(16) BvhNode {
    Real4 x, y, z;
    uint32_t child[2];
    uint32_t unused[2];
};
inline constexpr uint32_t kLeafBit = 0x80000000u;
inline constexpr uint32_t kLeafCountBits = 3;
inline constexpr uint32_t kMaxLeafSize = 1u << kLeafCountBits;
inline constexpr uint32_t kMaxLeafItems = 1u << (31 - kLeafCountBits);  // in all leaves of a tree
inline constexpr uint32_t kNoLeaf = 0xffffffffu;  // the bottom of the stack: no leaf has this code

/// Entries of the traversal stack. A builder makes no tree with more levels of nodes than this;
/// a level pushes at most one entry.
inline constexpr int kMaxTreeDepth = 32;

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

/// What rounding may do to a slab test's exit (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013).
inline constexpr Real kSlabGrowth = 1 + 8 * kEpsilon;

/// Calls `leaf(first, last)` for the leaves that the ray may meet within `t_max`, which `leaf` may
/// make smaller, near boxes first, until it returns true. `inverse` is 1 / direction.
///
/// There is one way out of each loop, at its end: lanes of a warp that leave by another run ahead,
/// and the compiler (ptxas of CUDA 13.0) lets them overwrite uniform registers in which those that
/// are still inside have the address of the nodes.
template <class Leaf>
TP_HD void visit_leaves(Span<const BvhNode> nodes, Vec3 origin, Vec3 inverse, const Real& t_max,
                        Leaf&& leaf) {
    uint32_t stack[kMaxTreeDepth + 1];
    stack[0] = kNoLeaf;
    int top = 1;
    uint32_t current = 0;
    bool is_done = false;
    do {
        while (!(current & kLeafBit)) {
            const BvhNode& node = nodes[current];
            const uint32_t child0 = node.child[0], child1 = node.child[1];
            Real entry0 = 0, exit0 = t_max, entry1 = 0, exit1 = t_max;
            clip_slab(node.x, origin.x, inverse.x, entry0, exit0, entry1, exit1);
            clip_slab(node.y, origin.y, inverse.y, entry0, exit0, entry1, exit1);
            clip_slab(node.z, origin.z, inverse.z, entry0, exit0, entry1, exit1);
            const bool met0 = entry0 <= exit0 * kSlabGrowth, met1 = entry1 <= exit1 * kSlabGrowth;
            if (met0 && met1) {
                const bool swap = entry1 < entry0;
                TP_ASSERT(top <= kMaxTreeDepth);
                stack[top++] = swap ? child0 : child1;
                current = swap ? child1 : child0;
            } else if (met0 || met1) {
                current = met0 ? child0 : child1;
            } else {
                current = stack[--top];
            }
        }
        is_done = current == kNoLeaf;
        if (!is_done) {
            const uint32_t first = (current & ~kLeafBit) >> kLeafCountBits;
            const uint32_t count = (current & (kMaxLeafSize - 1)) + 1;
            is_done = leaf(first, first + count);
            current = stack[--top];
        }
    } while (!is_done);
}

}  // namespace tp
