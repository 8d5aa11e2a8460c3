// Refraction through a rough interface between two dielectrics (Walter et al., "Microfacet Models
// for Refraction through Rough Surfaces", 2007), in the local frame of the shading normal, wo
// above. `eta` is the index beyond the interface over the index on the side of wo. Radiance is
// scaled by 1 / eta^2, as basic radiance demands.
#pragma once

#include <teapath/kernel/bsdf/dielectric.h>
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

/// The interface's reflectance by that rule.
TP_HD Real dielectric_fresnel(FresnelRule rule, Real cos_i, Real eta) {
    const Real cosine = min(cos_i, Real(1));
    return rule == FresnelRule::Schlick ? fresnel_schlick(cosine, eta)
                                        : fresnel_dielectric(cosine, eta);
}

/// f(wo, wi) |cos(wi)| of both lobes, white. Heights are correlated in reflection only.
TP_HD Real rough_dielectric_eval(FresnelRule rule, Real eta, Real alpha, bool correlated, Vec3 wo,
                                 Vec3 wi) {
    const GgxAlpha a{alpha, alpha};
    if (wi.z > 0) {
        const Vec3 h = normalize(wo + wi);
        return dielectric_fresnel(rule, dot(wo, h), eta) * ggx_reflection(a, wo, wi, h, correlated);
    }
    const Vec3 h = refraction_normal(wo, wi, eta);
    if (!(h.z > 0)) return 0;
    return (1 - dielectric_fresnel(rule, dot(wo, h), eta)) *
           ggx_refraction(a, wo, wi, h, eta, false);
}

TP_HD Real rough_dielectric_pdf(FresnelRule rule, Real eta, Real alpha, Vec3 wo, Vec3 wi) {
    const GgxAlpha a{alpha, alpha};
    if (wi.z > 0) {
        const Vec3 h = normalize(wo + wi);
        return dielectric_fresnel(rule, dot(wo, h), eta) * ggx_reflection_pdf(a, wo, h);
    }
    const Vec3 h = refraction_normal(wo, wi, eta);
    if (!(h.z > 0)) return 0;
    return (1 - dielectric_fresnel(rule, dot(wo, h), eta)) * refraction_pdf(a, wo, wi, h, eta);
}

/// Picks a facet, then by its reflectance one of the lobes with `choice` in [0, 1).
TP_HD BsdfSample rough_dielectric_sample(FresnelRule rule, Real eta, Real alpha, bool correlated,
                                         Vec3 wo, Vec2 u, Real choice) {
    const Vec3 h = sample_ggx_normal({alpha, alpha}, wo, u);
    BsdfSample sample;
    if (choice < dielectric_fresnel(rule, dot(wo, h), eta)) {
        sample.wi = reflect(wo, h);
        if (!(sample.wi.z > 0)) return {};
    } else {
        if (!refract(wo, h, eta, sample.wi) || !(sample.wi.z < 0)) return {};
        sample.eta_scale = sqr(eta);
    }
    sample.pdf = rough_dielectric_pdf(rule, eta, alpha, wo, sample.wi);
    if (!(sample.pdf > 0)) return {};
    sample.weight =
        Vec3(rough_dielectric_eval(rule, eta, alpha, correlated, wo, sample.wi) / sample.pdf);
    return sample;
}

}  // namespace tp
