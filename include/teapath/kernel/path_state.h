// The state of one path between steps, and what a step asks of the scene.
#pragma once

#include <teapath/kernel/traverse.h>

namespace tp {

struct PathState {
    Vec3 origin{0, 0, 0};       // of the next segment, moved off the surface that it leaves
    Vec3 direction{0, 0, 1};    // unit
    Real t_max = kInfinity;     // of the next segment; finite behind a far clip plane only
    Vec3 throughput{1, 1, 1};   // what radiance at the end of the next segment counts for
    Vec3 radiance{0, 0, 0};     // gathered so far
    Vec3 last{0, 0, 0};         // where `direction` was sampled
    Vec3 last_normal{0, 0, 0};  // unit, for shading, there
    Real bsdf_pdf = 0;   // density that sampled `direction`; 0 after a delta lobe or the camera
    Real eta_scale = 1;  // product of squared relative indices, taken out for Russian roulette
    bool one_channel = false;  // dispersion has left one of red, green, blue
    uint32_t depth = 1;        // segments, the next one counted
    uint32_t vertex = 1;       // surfaces met, the next one counted; numbers the random dimensions
};

/// A segment towards a point of a light, and what it brings if nothing lies between.
struct ShadowQuery {
    Vec3 origin{0, 0, 0};
    Vec3 direction{0, 0, 1};  // unit
    Real distance = 0;        // to the light's point
    Ignored ignored;          // the light, which cannot shadow itself
    Vec3 contribution{0, 0, 0};
    bool is_active = false;
};

}  // namespace tp
