// Radiance from beyond the scene.
#pragma once

#include <teapath/kernel/texture.h>

namespace tp {

/// Equirectangular coordinates of a unit direction: -z at the left and right edge, +x a quarter
/// from the left, v = 0 straight up.
TP_HD Vec2 equirectangular_uv(Vec3 d) {
    const Real u = std::atan2(d.x, -d.z) * (kInvPi / 2);
    return {u < 0 ? u + 1 : u, std::acos(clamp(d.y, Real(-1), Real(1))) * kInvPi};
}

/// A direction of the world as one of the image, before it was rotated.
TP_HD Vec3 turned_to_image(const BackgroundRecord& background, Vec3 d) {
    return {d.x * background.cos_rotation - d.z * background.sin_rotation, d.y,
            d.x * background.sin_rotation + d.z * background.cos_rotation};
}

/// The image in texture `texture` as a background: wraps in u, clamps in v, always bilinear. A
/// missing one (-1) is cyan.
TP_HD Vec3 image_background(const SceneView& scene, int32_t texture, Vec3 d) {
    if (texture < 0) return {0, 1, 1};
    const Vec2 uv = equirectangular_uv(turned_to_image(scene.background, d));
    const ImageRecord& image = scene.textures[static_cast<uint32_t>(texture)].image;
    const Real x = uv.x * static_cast<Real>(image.width) - Real(0.5);
    const Real y = uv.y * static_cast<Real>(image.height) - Real(0.5);
    const Real fx = std::floor(x), fy = std::floor(y);
    const int x0 = wrap_texel(static_cast<int>(fx), image.width, WrapMode::Repeat);
    const int x1 = wrap_texel(static_cast<int>(fx) + 1, image.width, WrapMode::Repeat);
    const int y0 = wrap_texel(static_cast<int>(fy), image.height, WrapMode::Clamp);
    const int y1 = wrap_texel(static_cast<int>(fy) + 1, image.height, WrapMode::Clamp);
    const Vec4 top =
        lerp(load_texel(scene, image, x0, y0), load_texel(scene, image, x1, y0), x - fx);
    const Vec4 bottom =
        lerp(load_texel(scene, image, x0, y1), load_texel(scene, image, x1, y1), x - fx);
    return Vec3(lerp(top, bottom, y - fy));
}

/// True if that unit direction meets the disk of the sun.
TP_HD bool meets_sun(const BackgroundRecord& background, Vec3 d) {
    return length_squared(d - background.sun_direction) < background.sun_chord2;
}

/// Radiance along the unit direction `d` of a ray that met nothing.
template <uint32_t kFeatures>
TP_HD Vec3 background_radiance(const SceneView& scene, Vec3 d) {
    const BackgroundRecord& background = scene.background;
    if constexpr ((kFeatures & kFeatureTextures) != 0) {
        const bool is_image =
            background.kind == BackgroundKind::Image || background.kind == BackgroundKind::Sky;
        if (is_image) {
            Vec3 color = image_background(scene, background.texture, d) * background.scale;
            if (meets_sun(background, d)) color += background.sun_radiance;
            return color;
        }
    }
    if (background.kind == BackgroundKind::Gradient)
        return lerp(background.bottom, background.top, (d.y + 1) / 2) * background.scale;
    return background.bottom * background.scale;
}

/// What the camera sees along `d` beyond the scene.
template <uint32_t kFeatures>
TP_HD Vec3 backdrop_radiance(const SceneView& scene, Vec3 d) {
    const BackgroundRecord& background = scene.background;
    if (background.backdrop == BackdropKind::Constant) return background.backdrop_color;
    if constexpr ((kFeatures & kFeatureTextures) != 0) {
        if (background.backdrop == BackdropKind::Image)
            return image_background(scene, background.backdrop_texture, d);
    }
    return background_radiance<kFeatures>(scene, d);
}

}  // namespace tp
