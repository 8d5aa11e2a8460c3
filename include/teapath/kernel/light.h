// Light sampling: a light by the alias table, then a point on its shape.
#pragma once

#include <teapath/kernel/scene_view.h>

namespace tp {

/// The light that `u` in [0, 1) picks, with LightRecord::probability.
TP_HD uint32_t pick_light(Span<const LightRecord> lights, Real u) {
    const Real scaled = u * static_cast<Real>(lights.size);
    const uint32_t column = min(static_cast<uint32_t>(scaled), lights.size - 1);
    const LightRecord& light = lights[column];
    return scaled - static_cast<Real>(column) < light.alias_threshold ? column : light.alias;
}

/// pdf over solid angle with which sampling a light from `from` finds `point` on emitter `h`.
TP_HD Real light_pdf(const SceneView& scene, const Hittable& h, Vec3 from, Vec3 direction,
                     const SurfacePoint& point, Real distance) {
    if (h.light == kNoLight) return 0;
    return scene.lights[h.light].probability * pdf_toward(h, from, direction, point, distance);
}

/// The power heuristic with exponent 2 (Veach 1997, 9.2.2.1) for the strategy with density `a`.
TP_HD Real mis_weight(Real a, Real b) {
    if (!(a < Real(1e18))) return 1;
    return a * a / (a * a + b * b);
}

}  // namespace tp
