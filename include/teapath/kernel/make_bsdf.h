// The bsdf of a material at a surface point.
#pragma once

#include <teapath/kernel/principled_surface.h>

namespace tp {

/// Fills the facets of `b`, a conductor or a dielectric.
template <uint32_t kFeatures>
TP_HD void place_facets(const SceneView& scene, const MaterialRecord& m, const Surface& s, Vec3 wo,
                        Bsdf& b) {
    const Real alpha = sqr(clamp(number_at<kFeatures>(scene, m.roughness, s), Real(0), Real(1)));
    b.is_rough = alpha >= kLeastAlpha;
    if (!b.is_rough && m.kind == MaterialKind::Dielectric) return;
    PlacedFacets& f = b.facets;
    f.frame = frame_around(s.normal);
    f.alpha = b.is_rough ? alpha : 0;
    f.correlated = m.correlated;
    f.gain = {1, 1, 1};
    f.eta = m.eta_rgb;
    f.k = m.k;
    if (!b.is_rough || !m.compensation) return;
    const Real cos_o = local_wo(f.frame, wo).z;
    if (m.kind == MaterialKind::Conductor) {
        const Vec2 albedo = ggx_albedo(scene.albedo_tables, cos_o, alpha);
        f.gain = conductor_gain(m.eta_rgb, m.k, albedo.x + albedo.y);
    } else {
        f.gain = Vec3(1 / max(glass_albedo(scene.albedo_tables, cos_o, alpha, b.eta), Real(0.1)));
    }
}

/// The bsdf, with `color` from surface_color, for a path that arrives along -wo; of what disperses,
/// that of one channel of red, green, blue, -1 for all.
template <uint32_t kFeatures>
TP_HD Bsdf make_bsdf(const SceneView& scene, const MaterialRecord& m, Vec3 color, const Surface& s,
                     Vec3 wo, ScatterRule scatter, int channel) {
    Bsdf b;
    b.kind = m.kind;
    b.fresnel = m.fresnel;
    b.scatter = scatter;
    b.color = color;
    b.normal = s.normal;
    if constexpr ((kFeatures & kFeaturePrincipled) != 0) {
        if (m.kind == MaterialKind::Principled) {
            make_principled_bsdf<kFeatures>(scene, m, color, s, wo, channel, b);
            return b;
        }
    }
    b.fuzz = m.fuzz;
    b.eta = s.front ? m.eta : 1 / m.eta;
    if constexpr ((kFeatures & kFeaturePrincipled) != 0) {
        const bool has_facets =
            m.kind == MaterialKind::Conductor || m.kind == MaterialKind::Dielectric;
        if (has_facets) place_facets<kFeatures>(scene, m, s, wo, b);
    }
    return b;
}

/// True if the index of refraction differs between the channels.
template <uint32_t kFeatures>
TP_HD bool disperses(const SceneView& scene, const MaterialRecord& m) {
    if constexpr ((kFeatures & kFeaturePrincipled) != 0) {
        if (m.kind == MaterialKind::Principled)
            return scene.principled[m.principled].ior_spread > 0;
    }
    return false;
}

/// What is left of light after `distance` within the material, for a surface met from behind.
template <uint32_t kFeatures>
TP_HD Vec3 transmittance_within(const SceneView& scene, const MaterialRecord& m, Real distance) {
    if constexpr ((kFeatures & kFeaturePrincipled) != 0) {
        if (m.kind == MaterialKind::Principled) {
            const PrincipledRecord& r = scene.principled[m.principled];
            if (!r.thin && !is_black(r.absorption)) {
                const Vec3 depth = r.absorption * distance;
                return {std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z)};
            }
        }
    }
    return {1, 1, 1};
}

}  // namespace tp
