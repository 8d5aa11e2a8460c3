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

/// The image as a background: wraps in u, clamps in v, always bilinear.
TP_HD Vec3 image_background(const SceneView& scene, const BackgroundRecord& background, Vec3 d) {
    const Vec2 uv = equirectangular_uv(turned_to_image(background, d));
    const ImageRecord& image = scene.textures[static_cast<uint32_t>(background.texture)].image;
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

/// Radiance along the unit direction `d` of a ray that met nothing. A missing image is cyan.
template <uint32_t kFeatures>
TP_HD Vec3 background_radiance(const SceneView& scene, Vec3 d) {
    const BackgroundRecord& background = scene.background;
    if ((kFeatures & kFeatureTextures) && background.kind == BackgroundKind::Image) {
        const Vec3 color =
            background.texture < 0 ? Vec3(0, 1, 1) : image_background(scene, background, d);
        return color * background.strength;
    }
    if (background.kind == BackgroundKind::Gradient) {
        return lerp(background.bottom, background.top, (d.y + 1) / 2) * background.strength;
    }
    return background.bottom * background.strength;
}

}  // namespace tp
