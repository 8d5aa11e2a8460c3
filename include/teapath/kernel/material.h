// A material at a surface point: its bsdf, what it emits, how much goes straight through.
#pragma once

#include <teapath/kernel/bsdf/bsdf.h>
#include <teapath/kernel/texture.h>

namespace tp {

/// A surface point as a ray found it.
struct Surface {
    SurfacePoint point;  // normal on the hittable's own side
    Vec3 normal;         // unit, on the side that the ray came from
    bool front = true;   // the ray came from the normal's side
    Vec2 uv{0, 0};       // of textures; zero in kernels without them
    uint32_t hittable = 0;
};

/// The surface where the ray met hittable `hit.index`.
template <uint32_t kFeatures>
TP_HD Surface make_surface(const SceneView& scene, const Hittable& h, Vec3 origin, Vec3 direction,
                           const Hit& hit) {
    Surface s;
    if constexpr ((kFeatures & kFeatureShapes) != 0) {
        s.point = surface_at(h, origin, direction, hit);
    } else {
        s.point = surface_at(h.sphere, origin, direction, hit);
        if (h.inside_out) s.point.normal = -s.point.normal;
    }
    s.front = dot(direction, s.point.normal) < 0;
    s.normal = s.front ? s.point.normal : -s.point.normal;
    s.hittable = hit.index;
    if constexpr ((kFeatures & kFeatureTextures) != 0) {
        if (!scene.textures.empty()) s.uv = texture_uv(h, s.point);
    }
    return s;
}

template <uint32_t kFeatures>
TP_HD Vec4 material_color(const SceneView& scene, const ColorRef& ref, const Surface& s) {
    if constexpr ((kFeatures & kFeatureTextures) != 0)
        return color_at(scene, ref, s.uv, s.point.position);
    else
        return Vec4(ref.color, 1);
}

/// True if the material emits towards a ray that met the side of the normal (`front`) or the other;
/// `turned_inwards` says that the normal points into a closed shape.
TP_HD bool emits_towards(const MaterialRecord& m, bool turned_inwards, bool front) {
    if (!m.emits) return false;
    if (m.side == EmissionSide::Both) return true;
    return m.side == EmissionSide::Outside ? front != turned_inwards : front;
}

template <uint32_t kFeatures>
TP_HD Vec3 emitted_radiance(const SceneView& scene, const MaterialRecord& m, const Surface& s) {
    const Vec3 color = Vec3(material_color<kFeatures>(scene, m.emission, s));
    return (kFeatures & kFeatureTextures) && m.emission.texture >= 0 ? color * m.strength : color;
}

/// The bsdf, with `color` from material_color of m.color.
TP_HD Bsdf make_bsdf(const MaterialRecord& m, Vec3 color, const Surface& s, ScatterRule scatter) {
    Bsdf b;
    b.kind = m.kind;
    b.fresnel = m.fresnel;
    b.scatter = scatter;
    b.color = color;
    b.normal = s.normal;
    b.fuzz = m.fuzz;
    b.eta = s.front ? m.eta : 1 / m.eta;
    return b;
}

}  // namespace tp
