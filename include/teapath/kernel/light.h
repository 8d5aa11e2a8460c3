// Light sampling: a light (light_tree.h), then a point on its shape.
#pragma once

#include <teapath/kernel/light_tree.h>
#include <teapath/kernel/material.h>

namespace tp {

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

/// What is read at a sampled point of a light: its place and texture coordinates.
template <uint32_t kFeatures>
TP_HD Surface surface_of_emitter(const SceneView& scene, const LightRecord& light,
                                 const Hittable& emitter, const SurfacePoint& point) {
    Surface s;
    s.point = point;
    s.normal = point.normal;
    note_place<kFeatures>(light.hittable, light.primitive, s);
    if constexpr ((kFeatures & kFeatureMeshes) != 0) {
        if (emitter.kind == HittableKind::Mesh) {
            const InstanceRecord& instance = scene.instances[emitter.mesh.instance];
            const MeshView& mesh = scene.meshes[instance.mesh];
            const MeshTriangle& triangle = mesh.triangles[light.primitive];
            add_mesh_attributes<kFeatures>(mesh, instance, triangle, s);
            if constexpr ((kFeatures & kFeatureProcedural) != 0)
                s.normal = shading_normal_at(mesh, instance, triangle, point);
            return s;
        }
    }
    if constexpr ((kFeatures & kFeatureTextures) != 0) s.uv = texture_uv(emitter, point);
    return s;
}

/// pdf over solid angle with which sample_emitter from `from` finds `point` of emitter `h`, which a
/// ray in `direction` met.
template <uint32_t kFeatures>
TP_HD Real emitter_pdf(const SceneView& scene, const Hittable& h, const Hit& hit, Vec3 from,
                       Vec3 direction, const SurfacePoint& point) {
    const Real distance = length(point.position - from);
    if constexpr ((kFeatures & kFeatureMeshes) != 0) {
        if (h.kind == HittableKind::Mesh) {
            const InstanceRecord& instance = scene.instances[h.mesh.instance];
            const MeshTriangle& t = scene.meshes[instance.mesh].triangles[hit.primitive];
            return solid_angle_pdf(1 / area_of(instance, t), distance, direction, point.normal);
        }
    }
    return pdf_toward(h, from, direction, point, distance);
}

/// The power heuristic with exponent 2 (Veach 1997, 9.2.2.1) for the strategy with density `a`.
TP_HD Real mis_weight(Real a, Real b) {
    if (!(a < Real(1e18))) return 1;
    return a * a / (a * a + b * b);
}

}  // namespace tp
