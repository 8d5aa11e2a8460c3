#include <teapath/scene/material.h>

namespace tp {

// Index of refraction at the three channels' wavelengths, from the handbook measurements that
// renderers share: Johnson and Christy 1972 for gold, silver and copper; Rakic et al. 1998 and
// Palik's handbook for the others.
ConductorIndex index_of(const Material& material) {
    switch (material.metal) {
        case ConductorMetal::Gold: return {{0.143, 0.375, 1.442}, {3.983, 2.386, 1.603}};
        case ConductorMetal::Silver: return {{0.155, 0.117, 0.138}, {4.828, 3.122, 2.147}};
        case ConductorMetal::Copper: return {{0.200, 0.924, 1.102}, {3.912, 2.452, 2.142}};
        case ConductorMetal::Aluminium: return {{1.657, 0.880, 0.521}, {9.224, 6.270, 4.837}};
        case ConductorMetal::Brass: return {{0.444, 0.527, 1.094}, {3.695, 2.765, 1.829}};
        case ConductorMetal::Chromium: return {{4.370, 2.917, 1.655}, {5.206, 4.231, 3.755}};
        case ConductorMetal::Tungsten: return {{4.371, 3.300, 2.998}, {3.501, 2.605, 2.273}};
        case ConductorMetal::Custom: break;
    }
    return {material.eta, material.k};
}

}  // namespace tp
