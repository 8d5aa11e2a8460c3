// What sampling a bsdf returns, and the terms that all its lobes share. Directions are unit, in
// world space, and point away from the surface: wo to where the path comes from, wi to where it
// goes. `normal` is on the side of wo.
#pragma once

#include <teapath/core/frame.h>
#include <teapath/kernel/warps.h>

namespace tp {

struct BsdfSample {
    Vec3 wi{0, 0, 0};
    Vec3 weight{0, 0, 0};  // f(wo, wi) |cos(wi)| / pdf; black = absorbed
    Real pdf = 0;          // over solid angle; 0 for a delta lobe
    Real eta_scale = 1;    // square of the relative index on refraction, for Russian roulette
};

}  // namespace tp
