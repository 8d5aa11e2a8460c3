// Builds the two-wide tree over hittables: binned surface area heuristic, on all cores.
#pragma once

#include <teapath/core/bounds.h>
#include <teapath/device/bvh_stats.h>
#include <teapath/kernel/bvh_node.h>

#include <cstdint>
#include <vector>

namespace tp {

struct BvhConfig {
    int bins = 16;           // of the centroids along each axis
    uint32_t leaf_size = 4;  // hittables at most, up to kMaxLeafSize
    double node_cost = 1.0;  // of visiting a node with its two boxes
    double leaf_cost = 0.6;  // of testing one hittable
    int max_depth =
        kMaxTreeDepth;  // levels of nodes; near the bound, medians replace the heuristic
};

struct BvhTree {
    std::vector<BvhNode> nodes;   // node 0 is the root; empty for no boxes
    std::vector<uint32_t> order;  // leaf position -> index of the box; each index once
    Bounds bounds;                // of everything
    BvhStats stats;
};

/// The tree of these boxes (finite, not empty). Deterministic, whatever the number of threads
/// (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007).
BvhTree build_bvh(const std::vector<Bounds>& boxes, const BvhConfig& config = {});

}  // namespace tp
