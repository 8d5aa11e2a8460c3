// Bump mapping (Blinn, "Simulation of Wrinkled Surfaces", 1978): the shading normal of a surface
// that a texture raises, by finite differences of the texture along the surface. The surface itself
// stays where it is. The gradient is taken as a vector of the tangent plane (Mikkelsen, "Bump
// Mapping Unparametrized Surfaces on the GPU", 2010), which adds to a normal map.
#pragma once

#include <teapath/kernel/uv_gradients.h>

namespace tp {

/// The point of the textures `offset` along the surface from `at`.
TP_HD TexturePoint moved(TexturePoint at, const UvGradients& g, Vec3 offset) {
    at.uv += Vec2(dot(g.u, offset), dot(g.v, offset));
    at.uv1 += Vec2(dot(g.u1, offset), dot(g.v1, offset));
    at.position += offset;
    return at;
}

/// How many units of the texture's space a scene unit is, at most.
TP_HD Real units_of(const SceneView& scene, TextureSpace space, const Surface& s,
                    const UvGradients& g) {
    if (space == TextureSpace::Uv) return tp::sqrt(max(dot(g.u, g.u), dot(g.v, g.v)));
    const Affine* map =
        space == TextureSpace::Object ? object_from_world(scene, s.hittable) : nullptr;
    return map ? max(length(map->linear[0]), max(length(map->linear[1]), length(map->linear[2])))
               : Real(1);
}

/// How fine the texture is at `s`: texels, or a twentieth of its smallest features, in a scene
/// unit. Of nested textures the outermost counts; 0 is a constant.
TP_HD Real detail_of(const SceneView& scene, const TextureRecord& texture, const Surface& s,
                     const UvGradients& g) {
    switch (texture.kind) {
        case TextureKind::Constant: break;
        case TextureKind::Image: {
            const ImageRecord& image = texture.image;
            const auto width = static_cast<Real>(image.width);
            const auto height = static_cast<Real>(image.height);
            if (image.projection == TextureProjection::Triplanar)
                return units_of(scene, image.space, s, g) *
                       max(width * length(Vec3(image.u.x, image.u.y, 0)),
                           height * length(Vec3(image.v.x, image.v.y, 0)));
            const Vec3& u = image.uv_set == 0 ? g.u : g.u1;
            const Vec3& v = image.uv_set == 0 ? g.v : g.v1;
            return max(width * length(u * image.u.x + v * image.u.y),
                       height * length(u * image.v.x + v * image.v.y));
        }
        case TextureKind::Checker: {
            const CheckerRecord& checker = texture.checker;
            if (checker.mode == CheckerMode::World) return 20 * abs(checker.frequency) * kInvPi;
            return 20 * max(abs(checker.cells.x), abs(checker.cells.y)) *
                   units_of(scene, TextureSpace::Uv, s, g);
        }
        case TextureKind::Noise:
        case TextureKind::Marble:
        case TextureKind::Wood:
        case TextureKind::Brick:
            return 20 * texture.pattern.detail * units_of(scene, texture.pattern.space, s, g);
    }
    return 0;
}

/// The slope of height `scale` times the texture's luminance along the surface at `s`, as a vector
/// of the tangent plane of s.normal; the height is along the front's normal.
TP_HD_NOINLINE Vec3 bump_slope(const SceneView& scene, int32_t texture, Real scale,
                               const Surface& s) {
    const UvGradients gradients = uv_gradients(scene, s);
    const Real detail =
        detail_of(scene, scene.textures[static_cast<uint32_t>(texture)], s, gradients);
    if (!(detail > 0) || scale == 0) return {0, 0, 0};
    // Central differences over a texel, and not within the rounding of the place.
    const Real step = max(Real(0.5) / detail, 32 * s.point.error);
    const TexturePoint here = texture_point<kFeatureAll>(s);
    const Frame frame = frame_around(s.normal);
    Vec3 slope{0, 0, 0};
    for (int i = 0; i < 4; ++i) {
        const Vec3 direction = (i < 2 ? frame.x : frame.y) * (i % 2 == 0 ? Real(1) : Real(-1));
        const Vec4 color = color_at<kFeatureAll>(scene, ColorRef{{0, 0, 0}, texture},
                                                 moved(here, gradients, direction * step));
        slope += direction * luminance(Vec3(color));
    }
    return slope * (scale / (2 * step));
}

/// The normal of the raised surface where the shape's is s.normal and a normal map has made
/// `mapped` of it. It faces `wo`: where the raised surface is turned away it is seen edge-on.
TP_HD Vec3 bumped_normal(const SceneView& scene, int32_t texture, Real scale, const Surface& s,
                         Vec3 mapped, Vec3 wo) {
    const Vec3 slope = bump_slope(scene, texture, scale, s);
    const Real side = s.front ? Real(1) : Real(-1);
    const Real upright = max(dot(mapped, s.normal), Real(0));
    const Vec3 raised = mapped - slope * (side * upright);
    const Real l2 = length_squared(raised);
    if (!(l2 > Real(1e-12)) || !(l2 < kInfinity)) return mapped;
    Vec3 normal = raised * tp::rsqrt(l2);
    const Real facing = dot(normal, wo);
    const Real least = Real(1e-3);
    if (facing < least) normal = normalize(normal + wo * (least - facing));
    return dot(normal, wo) > 0 ? normal : mapped;
}

}  // namespace tp
