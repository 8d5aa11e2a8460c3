// Builds the tree that lights are picked by (kernel/light_tree.h).
#pragma once

#include <teapath/core/bounds.h>
#include <teapath/kernel/records.h>

#include <cstdint>
#include <vector>

namespace tp {

/// Where a light is, where it shines and how strongly.
struct EmitterBounds {
    Bounds box;
    Vec3 axis{0, 0, 1};    // unit; of its normals
    Real cos_spread = -1;  // of the half angle of their cone
    Real cos_reach = 0;    // of the angle from a normal within which light is sent
    bool two_sided = false;
    double power = 0;
};

struct LightTree {
    std::vector<LightNode> nodes;  // depth first
    std::vector<uint32_t> trails;  // LightRecord::trail of each emitter
};

/// Splits by the surface area orientation heuristic in bins (Conty Estevez and Kulla 2018, 4.4);
/// never deeper than kMaxLightTreeDepth.
LightTree build_light_tree(const std::vector<EmitterBounds>& emitters);

}  // namespace tp
