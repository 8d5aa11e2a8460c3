// The parameters of a principled surface where a ray met it: textures looked up, normal and bump
// map applied.
#pragma once

#include <teapath/kernel/bump.h>

namespace tp {

template <uint32_t kFeatures>
TP_HD Real number_at(const SceneView& scene, const NumberRef& ref, const Surface& s) {
    if constexpr ((kFeatures & kFeatureTextures) != 0) {
        if (ref.texture >= 0)
            return ref.value * color_at<kFeatures>(scene, ColorRef{{0, 0, 0}, ref.texture},
                                                   texture_point<kFeatures>(s))[ref.channel];
    }
    return ref.value;
}

/// The frame of the shading normal, x along the tangent where one is known.
TP_HD Frame tangent_frame(const Surface& s, Vec3 normal) {
    const Vec3 along = Vec3(s.tangent) - normal * dot(Vec3(s.tangent), normal);
    const Real l2 = length_squared(along);
    if (!(l2 > Real(1e-20))) return frame_around(normal);
    const Vec3 x = along * tp::rsqrt(l2);
    return {x, cross(normal, x), normal};
}

/// The shading normal after a normal map: its numbers are 2 c - 1 of the texture's.
template <uint32_t kFeatures>
TP_HD Vec3 mapped_normal(const SceneView& scene, int32_t texture, Real scale, const Surface& s) {
    const Vec4 c =
        color_at<kFeatures>(scene, ColorRef{{0, 0, 0}, texture}, texture_point<kFeatures>(s));
    const Frame frame = tangent_frame(s, s.normal);
    // The tangent frame of the front, also when seen from behind.
    const Real side = s.front ? Real(1) : Real(-1);
    const Vec3 local{(2 * c.x - 1) * scale, (2 * c.y - 1) * scale * s.tangent.w * side,
                     2 * c.z - 1};
    const Real l2 = length_squared(local);
    return l2 > Real(1e-12) ? frame.to_world(local * tp::rsqrt(l2)) : s.normal;
}

TP_HD GgxAlpha ggx_alpha(Real roughness, Real anisotropy) {
    const Real alpha = max(sqr(clamp(roughness, Real(0), Real(1))), kLeastAlpha);
    // KHR_materials_anisotropy: towards 1 along the tangent.
    return {lerp(alpha, Real(1), sqr(anisotropy)), alpha};
}

/// The parameters but for the coat's normal; of what disperses, those of `channel`, -1 for all.
template <uint32_t kFeatures>
TP_HD PrincipledParameters principled_parameters(const SceneView& scene, const PrincipledRecord& r,
                                                 Vec3 base, const Surface& s, int channel) {
    const auto number = [&](const NumberRef& ref) { return number_at<kFeatures>(scene, ref, s); };
    const auto share = [&](const NumberRef& ref) { return clamp(number(ref), Real(0), Real(1)); };
    const auto color = [&](const ColorRef& ref) {
        return Vec3(material_color<kFeatures>(scene, ref, s));
    };
    PrincipledParameters p;
    p.base = base;
    p.metallic = share(r.metallic);
    p.alpha = ggx_alpha(number(r.roughness), share(r.anisotropy));
    p.thin = r.thin;
    p.compensation = r.compensation;
    const Real ior = channel < 0 ? r.ior : r.ior + static_cast<Real>(channel - 1) * r.ior_spread;
    p.eta = s.front || r.thin ? ior : 1 / ior;
    const Real f0 = sqr((ior - 1) / (ior + 1));
    p.f90 = share(r.specular);
    p.f0 = min(color(r.specular_color) * f0, Vec3(1, 1, 1)) * p.f90;
    p.transmission = share(r.transmission);
    p.diffuse_transmission = share(r.diffuse_transmission);
    p.diffuse_transmission_color = color(r.diffuse_transmission_color);
    p.coat = share(r.coat);
    p.coat_alpha = ggx_alpha(number(r.coat_roughness), 0).x;
    p.film = share(r.iridescence);
    if (p.film > 0) {
        p.film_ior = r.film_ior;
        p.film_thickness = lerp(r.film_low, r.film_high, share(r.film_thickness));
    }
    p.sheen = color(r.sheen_color);
    p.sheen_alpha = max(sqr(share(r.sheen_roughness)), kLeastSheenAlpha);
    return p;
}

/// Fills the principled part of `b` for the direction wo.
template <uint32_t kFeatures>
TP_HD void make_principled_bsdf(const SceneView& scene, const MaterialRecord& m, Vec3 color,
                                const Surface& s, Vec3 wo, int channel, Bsdf& b) {
    const PrincipledRecord& r = scene.principled[m.principled];
    Vec3 coat_normal = s.normal;
    if constexpr ((kFeatures & kFeatureTextures) != 0) {
        // A facet that the eye does not see stays as it is.
        const auto map = [&](int32_t texture, Real scale, Vec3& normal) {
            if (texture < 0) return;
            const Vec3 mapped = mapped_normal<kFeatures>(scene, texture, scale, s);
            if (dot(mapped, wo) > 0) normal = mapped;
        };
        map(r.normal, r.normal_scale, b.normal);
        map(r.coat_normal, r.coat_normal_scale, coat_normal);
    }
    if constexpr ((kFeatures & kFeatureProcedural) != 0) {
        if (r.bump >= 0) b.normal = bumped_normal(scene, r.bump, r.bump_scale, s, b.normal, wo);
    }
    PlacedLobes& placed = b.principled;
    placed.frame = tangent_frame(s, b.normal);
    if (r.anisotropy_sine != 0 || r.anisotropy_cosine != 1) {
        const Vec3 x = placed.frame.x * r.anisotropy_cosine + placed.frame.y * r.anisotropy_sine;
        placed.frame = {x, cross(b.normal, x), b.normal};
    }
    placed.tables = scene.albedo_tables;
    PrincipledParameters p = principled_parameters<kFeatures>(scene, r, color, s, channel);
    if (r.normal >= 0 || r.bump >= 0 || r.coat_normal >= 0)
        p.coat_normal = placed.frame.to_local(coat_normal);
    placed.lobes = make_principled(p, scene.albedo_tables, placed.local_wo(wo));
}

}  // namespace tp
