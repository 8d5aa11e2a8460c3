// A material at a surface point: its colour, what it emits, how much goes straight through.
#pragma once

#include <teapath/kernel/bsdf/bsdf.h>
#include <teapath/kernel/mesh/mesh_surface.h>
#include <teapath/kernel/texture.h>

namespace tp {

/// A surface point as a ray found it.
struct Surface {
    SurfacePoint point;      // normal on the hittable's own side
    Vec3 normal;             // unit, for shading, on the side that the ray came from
    bool front = true;       // the ray came from the geometric normal's side
    Vec2 uv{0, 0};           // of textures, set 0; zero in kernels without them
    Vec2 uv1{0, 0};          // set 1 of a mesh
    Vec4 color{1, 1, 1, 1};  // of a mesh's vertices; multiplies the material's
    // Of what has a direction along the surface: +x of normal maps, and the sign of the bitangent
    // w * n x t, which points to the top of the image. Zero: none is known.
    Vec4 tangent{0, 0, 0, 1};
    uint32_t hittable = kNoHit, primitive = 0;  // where procedural textures are
};

/// Where the surface's textures are read.
template <uint32_t kFeatures>
TP_HD TexturePoint texture_point(const Surface& s) {
    TexturePoint at{s.uv, s.uv1, s.point.position};
    if constexpr ((kFeatures & kFeatureProcedural) != 0) {
        at.normal = dot(s.normal, s.point.normal) < 0 ? -s.normal : s.normal;
        at.hittable = s.hittable;
    }
    return at;
}

/// Fills what a mesh knows of its surface at triangle `primitive`, at the weights in s.point.uv.
template <uint32_t kFeatures>
TP_HD void add_mesh_attributes(const MeshView& mesh, const InstanceRecord& instance,
                               const MeshTriangle& triangle, Surface& s) {
    if constexpr ((kFeatures & kFeatureTextures) != 0) {
        s.uv = mesh_uv(mesh, triangle, s.point.uv, 0);
        s.uv1 = mesh_uv(mesh, triangle, s.point.uv, 1);
    }
    if constexpr ((kFeatures & kFeaturePrincipled) != 0)
        s.tangent = mesh_tangent(mesh, instance, triangle, s.point);
    if (mesh.attributes.colors)
        s.color = interpolate(mesh.attributes.colors, triangle, barycentric_at(s.point.uv));
}

/// Notes where the surface is, which textures of its object's space and bump maps look up.
template <uint32_t kFeatures>
TP_HD void note_place(uint32_t hittable, uint32_t primitive, Surface& s) {
    if constexpr ((kFeatures & kFeatureProcedural) != 0) {
        s.hittable = hittable;
        s.primitive = primitive;
    }
}

/// The surface where the ray met a mesh.
template <uint32_t kFeatures>
TP_HD Surface make_mesh_surface(const SceneView& scene, const Hittable& h, Vec3 direction,
                                const Hit& hit) {
    const InstanceRecord& instance = scene.instances[h.mesh.instance];
    const MeshView& mesh = scene.meshes[instance.mesh];
    const MeshTriangle& triangle = mesh.triangles[hit.primitive];
    Surface s;
    s.point = mesh_point(instance, triangle, barycentric_at({hit.u, hit.v}));
    const Vec3 shading = shading_normal_at(mesh, instance, triangle, s.point);
    if (h.inside_out) s.point.normal = -s.point.normal;
    s.front = dot(direction, s.point.normal) < 0;
    s.normal = dot(direction, shading) < 0 ? shading : -shading;
    add_mesh_attributes<kFeatures>(mesh, instance, triangle, s);
    note_place<kFeatures>(hit.index, hit.primitive, s);
    return s;
}

/// The surface where the ray met hittable `hit.index`.
template <uint32_t kFeatures>
TP_HD Surface make_surface(const SceneView& scene, const Hittable& h, Vec3 origin, Vec3 direction,
                           const Hit& hit) {
    if constexpr ((kFeatures & kFeatureMeshes) != 0) {
        if (h.kind == HittableKind::Mesh)
            return make_mesh_surface<kFeatures>(scene, h, direction, hit);
    }
    Surface s;
    if constexpr ((kFeatures & kFeatureShapes) != 0) {
        s.point = surface_at(h, origin, direction, hit);
    } else {
        s.point = surface_at(h.sphere, origin, direction, hit);
        if (h.inside_out) s.point.normal = -s.point.normal;
    }
    s.front = dot(direction, s.point.normal) < 0;
    s.normal = s.front ? s.point.normal : -s.point.normal;
    if constexpr ((kFeatures & kFeatureTextures) != 0) {
        if (!scene.textures.empty()) s.uv = texture_uv(h, s.point);
    }
    if constexpr ((kFeatures & kFeaturePrincipled) != 0) {
        s.tangent = shape_tangent(h, s.point.normal);
    }
    note_place<kFeatures>(hit.index, hit.primitive, s);
    return s;
}

template <uint32_t kFeatures>
TP_HD Vec4 material_color(const SceneView& scene, const ColorRef& ref, const Surface& s) {
    if constexpr ((kFeatures & kFeatureTextures) != 0)
        return color_at<kFeatures>(scene, ref, texture_point<kFeatures>(s));
    else
        return Vec4(ref.color, 1);
}

/// The material's colour and alpha at `s`, with the colours of a mesh's vertices.
template <uint32_t kFeatures>
TP_HD Vec4 surface_color(const SceneView& scene, const MaterialRecord& m, const Surface& s) {
    const Vec4 color = material_color<kFeatures>(scene, m.color, s);
    if constexpr ((kFeatures & kFeatureMeshes) != 0)
        return color * s.color;
    else
        return color;
}

/// What the feature planes and the Flat integrator show of a surface.
template <uint32_t kFeatures>
TP_HD Vec3 albedo_of(const SceneView& scene, const MaterialRecord& m, const Surface& s) {
    if (m.kind == MaterialKind::DiffuseLight)
        return Vec3(material_color<kFeatures>(scene, m.emission, s));
    return Vec3(surface_color<kFeatures>(scene, m, s));
}

/// The share of light that meets the material where its colour has this alpha.
TP_HD Real opacity_of(const MaterialRecord& m, Real alpha) {
    if (m.alpha == AlphaMode::Opaque) return m.opacity;
    const Real opacity = m.opacity * alpha;
    if (m.alpha == AlphaMode::Mask) return opacity < m.alpha_cutoff ? 0 : 1;
    return opacity;
}

/// True if the material emits towards a ray that met the side of the normal (`front`) or the other;
/// `turned_inwards` says that the normal points into a closed shape.
TP_HD bool emits_towards(const MaterialRecord& m, bool turned_inwards, bool front) {
    if (!m.emits) return false;
    if (m.side == EmissionSide::Both) return true;
    return m.side == EmissionSide::Outside ? front != turned_inwards : front;
}

/// The share of its emission that a light with a cone sends at this cosine from its normal
/// (KHR_lights_punctual).
TP_HD Real cone_share(const MaterialRecord& m, Real cosine) {
    if (m.cone_gain == 0) return 1;
    return sqr(clamp((abs(cosine) - m.cone_cosine) * m.cone_gain, Real(0), Real(1)));
}

/// True if the material lets light through in lobes of its bsdf.
template <uint32_t kFeatures>
TP_HD bool transmits(const SceneView& scene, const MaterialRecord& m) {
    if (m.kind == MaterialKind::Dielectric) return true;
    if constexpr ((kFeatures & kFeaturePrincipled) != 0) {
        if (m.kind == MaterialKind::Principled) {
            const PrincipledRecord& r = scene.principled[m.principled];
            return r.transmission.value > 0 || r.diffuse_transmission.value > 0;
        }
    }
    return false;
}

/// Moves the point of a smooth mesh that rays leave from where its triangle is to where its normals
/// say that the surface is: else the triangle's own edge shadows what they light.
template <uint32_t kFeatures>
TP_HD void lift_off_mesh(const SceneView& scene, const Hittable& h, const MaterialRecord& m,
                         const Hit& hit, Surface& s) {
    if (h.kind != HittableKind::Mesh || transmits<kFeatures>(scene, m)) return;
    const InstanceRecord& instance = scene.instances[h.mesh.instance];
    const MeshView& mesh = scene.meshes[instance.mesh];
    if (!instance.smooth || !mesh.attributes.normals) return;
    s.point.position = lifted_position(mesh, instance, mesh.triangles[hit.primitive],
                                       barycentric_at({hit.u, hit.v}), s.point.position, s.normal);
}

template <uint32_t kFeatures>
TP_HD Vec3 emitted_radiance(const SceneView& scene, const MaterialRecord& m, const Surface& s) {
    const Vec3 color = Vec3(material_color<kFeatures>(scene, m.emission, s));
    return (kFeatures & kFeatureTextures) && m.emission.texture >= 0 ? color * m.strength : color;
}

}  // namespace tp
