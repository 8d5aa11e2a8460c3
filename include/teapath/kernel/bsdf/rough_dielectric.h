// Refraction through a rough interface between two dielectrics (Walter et al., "Microfacet Models
// for Refraction through Rough Surfaces", 2007), in the local frame of the shading normal, wo
// above. `eta` is the index beyond the interface over the index on the side of wo. Radiance is
// scaled by 1 / eta^2, as basic radiance demands.
#pragma once

#include <teapath/kernel/bsdf/ggx.h>

namespace tp {

/// The normal of the facet that refracts wo (z > 0) into wi (z < 0), z > 0; (0, 0, 0) if none does.
TP_HD Vec3 refraction_normal(Vec3 wo, Vec3 wi, Real eta) {
    Vec3 h = wi * eta + wo;
    const Real l2 = length_squared(h);
    if (!(l2 > Real(1e-20))) return {0, 0, 0};
    h *= tp::rsqrt(l2);
    if (h.z < 0) h = -h;
    const bool possible = dot(wo, h) > 0 && dot(wi, h) < 0;
    return possible ? h : Vec3(0, 0, 0);
}

/// Refracts wo about the facet `h`; false at total reflection.
TP_HD bool refract(Vec3 wo, Vec3 h, Real eta, Vec3& wi) {
    const Real cos_o = dot(wo, h);
    const Real inverse = 1 / eta;
    const Real cos2_t = 1 - (1 - cos_o * cos_o) * inverse * inverse;
    if (!(cos2_t > 0)) return false;
    wi = h * (inverse * cos_o - tp::sqrt(cos2_t)) - wo * inverse;
    return true;
}

/// Density over solid angle of refracting about a sampled normal.
TP_HD Real refraction_pdf(GgxAlpha a, Vec3 wo, Vec3 wi, Vec3 h, Real eta) {
    const Real o = dot(wo, h), i = dot(wi, h);
    return ggx_normal_pdf(a, wo, h) * abs(i) / sqr(i + o / eta);
}

/// The interface's bsdf for refraction without its transmittance, times |cos(wi)|.
TP_HD Real ggx_refraction(GgxAlpha a, Vec3 wo, Vec3 wi, Vec3 h, Real eta, bool correlated) {
    const Real o = dot(wo, h), i = dot(wi, h);
    return ggx_density(a, h) * ggx_masking(a, wo, wi, correlated) * abs(i * o) /
           (wo.z * sqr(i + o / eta) * eta * eta);
}

}  // namespace tp
