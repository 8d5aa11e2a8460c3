// Fibres standing on a surface (Estevez and Kulla, "Production Friendly Microfacet Sheen BRDF",
// 2017), in the local frame of the shading normal.
#pragma once

#include <teapath/core/math.h>

#include <cmath>

namespace tp {

inline constexpr Real kLeastSheenAlpha = Real(0.005);

/// The paper's fit of the masking's exponent, between its two sets of constants.
TP_HD Real sheen_exponent(Real x, Real alpha) {
    const Real t = sqr(1 - alpha);
    const Real a = lerp(Real(21.5473), Real(25.3245), t), b = lerp(Real(3.82987), Real(3.32435), t);
    const Real c = lerp(Real(0.19823), Real(0.16801), t);
    const Real d = lerp(Real(-1.97760), Real(-1.27393), t);
    const Real e = lerp(Real(-4.32054), Real(-4.85967), t);
    return a / (1 + b * std::pow(x, c)) + d * x + e;
}
TP_HD Real sheen_lambda(Real cosine, Real alpha) {
    if (cosine < Real(0.5)) return std::exp(sheen_exponent(cosine, alpha));
    const Real rest = max(1 - cosine, Real(0));  // a cosine may be above 1 by rounding
    return std::exp(2 * sheen_exponent(Real(0.5), alpha) - sheen_exponent(rest, alpha));
}

/// The lobe of white fibres, times |cos(wi)|; both directions above the surface.
TP_HD Real sheen_reflection(Real alpha, Vec3 wo, Vec3 wi) {
    const Vec3 h = normalize(wo + wi);
    const Real sine = safe_sqrt(1 - h.z * h.z);
    const Real density = (2 + 1 / alpha) * std::pow(sine, 1 / alpha) * (kInvPi / 2);
    const Real masking = 1 + sheen_lambda(wo.z, alpha) + sheen_lambda(wi.z, alpha);
    return density / (4 * wo.z * masking);
}

}  // namespace tp
