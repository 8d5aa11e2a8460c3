// A metal by its complex index of refraction: a mirror, or GGX facets with the exact reflectance.
// Directions are in the local frame of the shading normal, wo above.
#pragma once

#include <teapath/kernel/bsdf/bsdf_sample.h>
#include <teapath/kernel/bsdf/ggx.h>
#include <teapath/kernel/bsdf/metal.h>

namespace tp {

/// Reflectance of unpolarised light for the cosine of incidence and the index eta + i k over that
/// of the medium before the interface (Born and Wolf, "Principles of Optics", 14.2).
TP_HD Real fresnel_conductor(Real cos_i, Real eta, Real k) {
    const Real cos2 = cos_i * cos_i, sin2 = 1 - cos2;
    // a and b: real and imaginary part of the root of (eta + i k)^2 - sin^2.
    const Real real = eta * eta - k * k - sin2;
    const Real a2b2 = tp::sqrt(sqr(real) + 4 * sqr(eta * k));
    const Real a = tp::sqrt(max((a2b2 + real) / 2, Real(0)));
    const Real perpendicular = (a2b2 + cos2 - 2 * a * cos_i) / (a2b2 + cos2 + 2 * a * cos_i);
    const Real parallel = perpendicular * (cos2 * a2b2 + sqr(sin2) - 2 * a * cos_i * sin2) /
                          (cos2 * a2b2 + sqr(sin2) + 2 * a * cos_i * sin2);
    return (perpendicular + parallel) / 2;
}

TP_HD Vec3 fresnel_conductor(Real cos_i, Vec3 eta, Vec3 k) {
    return {fresnel_conductor(cos_i, eta.x, k.x), fresnel_conductor(cos_i, eta.y, k.y),
            fresnel_conductor(cos_i, eta.z, k.z)};
}

/// What makes up for the energy that one scattering loses (Turquin, "Practical multiple scattering
/// compensation for microfacet models", 2019), for the albedo of white facets seen from wo.
TP_HD Vec3 conductor_gain(Vec3 eta, Vec3 k, Real albedo) {
    return Vec3(1, 1, 1) + fresnel_conductor(1, eta, k) * (1 / max(albedo, Real(0.1)) - 1);
}

/// f(wo, wi) |cos(wi)| of rough ones.
TP_HD Vec3 conductor_eval(Vec3 eta, Vec3 k, Vec3 tint, Real alpha, bool correlated, Vec3 wo,
                          Vec3 wi) {
    if (!(wi.z > 0)) return {0, 0, 0};
    const Vec3 h = normalize(wo + wi);
    return tint * fresnel_conductor(min(dot(wo, h), Real(1)), eta, k) *
           ggx_reflection({alpha, alpha}, wo, wi, h, correlated);
}

TP_HD Real conductor_pdf(Real alpha, Vec3 wo, Vec3 wi) {
    return wi.z > 0 ? ggx_reflection_pdf({alpha, alpha}, wo, normalize(wo + wi)) : 0;
}

TP_HD BsdfSample conductor_sample(Vec3 eta, Vec3 k, Vec3 tint, Real alpha, bool correlated, Vec3 wo,
                                  Vec2 u) {
    if (alpha <= 0) {
        return {{-wo.x, -wo.y, wo.z}, tint * fresnel_conductor(min(wo.z, Real(1)), eta, k), 0, 1};
    }
    const Vec3 wi = reflect(wo, sample_ggx_normal({alpha, alpha}, wo, u));
    const Real pdf = conductor_pdf(alpha, wo, wi);
    if (!(pdf > 0)) return {};
    return {wi, conductor_eval(eta, k, tint, alpha, correlated, wo, wi) / pdf, pdf, 1};
}

}  // namespace tp
