// A smooth interface between two dielectrics: one of two delta lobes is picked by the Fresnel
// reflectance.
#pragma once

#include <teapath/kernel/bsdf/bsdf_sample.h>
#include <teapath/kernel/bsdf/metal.h>
#include <teapath/kernel/kinds.h>

namespace tp {

/// Reflectance of unpolarised light for the cosine of incidence and eta = index beyond the
/// interface over index before it; 1 at total reflection.
TP_HD Real fresnel_dielectric(Real cos_i, Real eta) {
    const Real sin2_t = (1 - cos_i * cos_i) / (eta * eta);
    if (sin2_t >= 1) return 1;
    const Real cos_t = tp::sqrt(1 - sin2_t);
    const Real parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    const Real perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    return (parallel * parallel + perpendicular * perpendicular) / 2;
}

/// Schlick's approximation ("An Inexpensive BRDF Model for Physically-based Rendering", 1994) as
/// the books use it: by the cosine of incidence on both sides, with total reflection kept.
TP_HD Real fresnel_schlick(Real cos_i, Real eta) {
    if ((1 - cos_i * cos_i) >= eta * eta) return 1;
    const Real r0 = sqr((1 - eta) / (1 + eta));
    const Real m = 1 - cos_i;
    return r0 + (1 - r0) * m * m * m * m * m;
}

/// Radiance is scaled by 1 / eta^2 on refraction, as basic radiance demands.
TP_HD BsdfSample dielectric_sample(Vec3 tint, Real eta, FresnelRule rule, Vec3 normal, Vec3 wo,
                                   Real u) {
    const Real cos_i = min(dot(normal, wo), Real(1));
    const Real reflectance =
        rule == FresnelRule::Schlick ? fresnel_schlick(cos_i, eta) : fresnel_dielectric(cos_i, eta);
    if (u < reflectance) return {reflect(wo, normal), tint, 0, 1};
    const Real inverse = 1 / eta;
    const Real cos_t = safe_sqrt(1 - (1 - cos_i * cos_i) * inverse * inverse);
    const Vec3 wi = normal * (inverse * cos_i - cos_t) - wo * inverse;
    return {normalize(wi), tint * (inverse * inverse), 0, eta * eta};
}

}  // namespace tp
