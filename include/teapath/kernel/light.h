// Light sampling: a light by the alias table, then a point on its shape.
#pragma once

#include <teapath/kernel/mesh/mesh_surface.h>
#include <teapath/kernel/scene_view.h>

namespace tp {

/// The light that `u` in [0, 1) picks, with LightRecord::probability.
TP_HD uint32_t pick_light(Span<const LightRecord> lights, Real u) {
    const Real scaled = u * static_cast<Real>(lights.size);
    const uint32_t column = min(static_cast<uint32_t>(scaled), lights.size - 1);
    const LightRecord& light = lights[column];
    return scaled - static_cast<Real>(column) < light.alias_threshold ? column : light.alias;
}

/// A point of the light's shape or triangle as seen from `from`, by area or better; pdf over solid
/// angle.
template <uint32_t kFeatures>
TP_HD ShapeSample sample_emitter(const SceneView& scene, const LightRecord& light, Vec3 from,
                                 Vec2 u) {
    const Hittable& h = scene.hittables[light.hittable];
    if constexpr ((kFeatures & kFeatureMeshes) != 0) {
        if (h.kind == HittableKind::Mesh) {
            const InstanceRecord& instance = scene.instances[h.mesh.instance];
            const MeshTriangle& t = scene.meshes[instance.mesh].triangles[light.primitive];
            SurfacePoint point =
                mesh_point(instance, t, barycentric_at(sample_uniform_triangle(u)));
            if (h.inside_out) point.normal = -point.normal;
            return sample_of_point(point, from, 1 / area_of(instance, t));
        }
    }
    return sample_toward(h, from, u);
}

/// pdf over solid angle with which sampling a light from `from` finds `point`, which a ray in
/// `direction` met on emitter `h`.
template <uint32_t kFeatures>
TP_HD Real light_pdf(const SceneView& scene, const Hittable& h, const Hit& hit, Vec3 from,
                     Vec3 direction, const SurfacePoint& point) {
    if (h.light == kNoLight) return 0;
    if constexpr ((kFeatures & kFeatureMeshes) != 0) {
        if (h.kind == HittableKind::Mesh) {
            const InstanceRecord& instance = scene.instances[h.mesh.instance];
            const MeshTriangle& t = scene.meshes[instance.mesh].triangles[hit.primitive];
            return scene.lights[h.light + hit.primitive].probability *
                   solid_angle_pdf(1 / area_of(instance, t), hit.t, direction, point.normal);
        }
    }
    return scene.lights[h.light].probability * pdf_toward(h, from, direction, point, hit.t);
}

/// The power heuristic with exponent 2 (Veach 1997, 9.2.2.1) for the strategy with density `a`.
TP_HD Real mis_weight(Real a, Real b) {
    if (!(a < Real(1e18))) return 1;
    return a * a / (a * a + b * b);
}

}  // namespace tp
