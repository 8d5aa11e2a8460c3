// The GGX distribution of microfacets with Smith's masking, anisotropic. Directions are unit, in
// the local frame of the shading normal (z), with the tangent along x. Trowbridge and Reitz 1975;
// Walter et al., "Microfacet Models for Refraction through Rough Surfaces", 2007; Heitz,
// "Understanding the Masking-Shadowing Function", JCGT 3(2), 2014.
#pragma once

#include <teapath/kernel/warps.h>

namespace tp {

/// Widths along x and y; roughness squared where it is the same in both.
struct GgxAlpha {
    Real x, y;
};

/// Below this width a facet's density leaves the range of float: what is smoother is as smooth.
inline constexpr Real kLeastAlpha = Real(1e-3);

/// Density of facets with normal `h` over projected area.
TP_HD Real ggx_density(GgxAlpha a, Vec3 h) {
    const Real d = sqr(h.x / a.x) + sqr(h.y / a.y) + sqr(h.z);
    return 1 / (kPi * a.x * a.y * d * d);
}

/// Smith's Lambda of a direction, on either side.
TP_HD Real ggx_lambda(GgxAlpha a, Vec3 w) {
    const Real z2 = w.z * w.z;
    if (!(z2 > 0)) return kInfinity;
    return (tp::sqrt(1 + (sqr(a.x * w.x) + sqr(a.y * w.y)) / z2) - 1) / 2;
}

/// The share of facets that `w` sees.
TP_HD Real ggx_masking(GgxAlpha a, Vec3 w) {
    return 1 / (1 + ggx_lambda(a, w));
}

/// The share that both directions see: heights correlated, or the product of both maskings.
TP_HD Real ggx_masking(GgxAlpha a, Vec3 wo, Vec3 wi, bool correlated) {
    const Real o = ggx_lambda(a, wo), i = ggx_lambda(a, wi);
    return correlated ? 1 / (1 + o + i) : 1 / ((1 + o) * (1 + i));
}

/// Density over solid angle of sample_ggx_normal.
TP_HD Real ggx_normal_pdf(GgxAlpha a, Vec3 wo, Vec3 h) {
    return ggx_masking(a, wo) * ggx_density(a, h) * max(dot(wo, h), Real(0)) / wo.z;
}

/// A normal of the facets that `wo` (z > 0) sees (Dupuy and Benyoub, "Sampling Visible GGX Normals
/// with Spherical Caps", 2023).
TP_HD Vec3 sample_ggx_normal(GgxAlpha a, Vec3 wo, Vec2 u) {
    const Vec3 stretched = normalize(Vec3(wo.x * a.x, wo.y * a.y, wo.z));
    const Real z = (1 - u.x) * (1 + stretched.z) - stretched.z;
    const Vec3 h = direction_at(clamp(z, Real(-1), Real(1)), u.y) + stretched;
    return normalize(Vec3(h.x * a.x, h.y * a.y, max(h.z, Real(1e-12))));
}

/// Reflection by the facets without their reflectance: density, masking and Jacobian, times
/// |cos(wi)|. Both directions above the surface.
TP_HD Real ggx_reflection(GgxAlpha a, Vec3 wo, Vec3 wi, Vec3 h, bool correlated) {
    return ggx_density(a, h) * ggx_masking(a, wo, wi, correlated) / (4 * wo.z);
}
/// Density over solid angle of reflecting about a sampled normal.
TP_HD Real ggx_reflection_pdf(GgxAlpha a, Vec3 wo, Vec3 h) {
    return ggx_masking(a, wo) * ggx_density(a, h) / (4 * wo.z);
}

}  // namespace tp
