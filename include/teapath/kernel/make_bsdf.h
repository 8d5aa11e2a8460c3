// The bsdf of a material at a surface point.
#pragma once

#include <teapath/kernel/principled_surface.h>

namespace tp {

/// The bsdf, with `color` from surface_color, for a path that arrives along -wo.
template <uint32_t kFeatures>
TP_HD Bsdf make_bsdf(const SceneView& scene, const MaterialRecord& m, Vec3 color, const Surface& s,
                     Vec3 wo, ScatterRule scatter) {
    Bsdf b;
    b.kind = m.kind;
    b.fresnel = m.fresnel;
    b.scatter = scatter;
    b.color = color;
    b.normal = s.normal;
    if constexpr ((kFeatures & kFeaturePrincipled) != 0) {
        if (m.kind == MaterialKind::Principled) {
            make_principled_bsdf<kFeatures>(scene, m, color, s, wo, b);
            return b;
        }
    }
    b.fuzz = m.fuzz;
    b.eta = s.front ? m.eta : 1 / m.eta;
    return b;
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
