// Texture look-up: constant, checker, image, and the patterns of procedural.h, nested without
// recursion. Filtering is ours on both processors, since the hardware's bilinear weights have 8
// fractional bits.
#pragma once

#include <teapath/core/color.h>
#include <teapath/kernel/procedural.h>

namespace tp {

/// The index inside [0, size) that texel `i` of a wrapped image means.
TP_HD int wrap_texel(int i, int size, WrapMode wrap) {
    if (wrap == WrapMode::Clamp) return clamp(i, 0, size - 1);
    const int period = wrap == WrapMode::Mirror ? 2 * size : size;
    int r = i % period;
    if (r < 0) r += period;
    return r < size ? r : period - 1 - r;
}

/// One texel as linear RGBA; alpha 1 where the image has none.
TP_HD Vec4 load_texel(const SceneView& scene, const ImageRecord& image, int x, int y) {
    const uint64_t first =
        (static_cast<uint64_t>(y) * static_cast<uint64_t>(image.width) + static_cast<uint64_t>(x)) *
        static_cast<uint64_t>(image.channels);
    const unsigned char* texels = scene.texels + image.offset;
    float value[4] = {0, 0, 0, 1};
    const int alpha = image.channels == 2 || image.channels == 4 ? image.channels - 1 : -1;
    for (int c = 0; c < image.channels; ++c) {
        const bool decode = image.is_srgb && c != alpha;
        if (image.bytes_per_channel == 1) {
            const unsigned char code = texels[first + static_cast<uint64_t>(c)];
            value[c] = decode ? scene.srgb_table[code] : static_cast<float>(code) * (1.0f / 255.0f);
        } else if (image.bytes_per_channel == 2) {
            const auto* codes = reinterpret_cast<const uint16_t*>(texels);
            const float x01 =
                static_cast<float>(codes[first + static_cast<uint64_t>(c)]) * (1.0f / 65535.0f);
            value[c] = decode ? linear_from_srgb(x01) : x01;
        } else {
            const auto* numbers = reinterpret_cast<const float*>(texels);
            value[c] = numbers[first + static_cast<uint64_t>(c)];
            if (decode) value[c] = linear_from_srgb(value[c]);
        }
    }
    if (image.channels <= 2) {
        const float a = image.channels == 2 ? value[1] : 1.0f;
        return Vec4(value[0], value[0], value[0], a);
    }
    return Vec4(value[0], value[1], value[2], value[3]);
}

/// An image at (u, v) of the surface: texel centres at (i + 0.5) / size, v = 0 at the top row.
TP_HD Vec4 sample_image(const SceneView& scene, const ImageRecord& image, Vec2 uv) {
    const Vec3 at{uv.x, uv.y, 1};
    const Real x = dot(at, image.u) * static_cast<Real>(image.width);
    const Real y = dot(at, image.v) * static_cast<Real>(image.height);
    const Real limit = Real(1e9);  // far-off coordinates stay inside int
    if (image.filter == FilterMode::Nearest) {
        const int ix = static_cast<int>(std::floor(clamp(x, -limit, limit)));
        const int iy = static_cast<int>(std::floor(clamp(y, -limit, limit)));
        return load_texel(scene, image, wrap_texel(ix, image.width, image.wrap_u),
                          wrap_texel(iy, image.height, image.wrap_v));
    }
    const Real cx = clamp(x - Real(0.5), -limit, limit), cy = clamp(y - Real(0.5), -limit, limit);
    const Real fx = std::floor(cx), fy = std::floor(cy);
    const int x0 = wrap_texel(static_cast<int>(fx), image.width, image.wrap_u);
    const int x1 = wrap_texel(static_cast<int>(fx) + 1, image.width, image.wrap_u);
    const int y0 = wrap_texel(static_cast<int>(fy), image.height, image.wrap_v);
    const int y1 = wrap_texel(static_cast<int>(fy) + 1, image.height, image.wrap_v);
    const Real wx = cx - fx, wy = cy - fy;
    const Vec4 top = lerp(load_texel(scene, image, x0, y0), load_texel(scene, image, x1, y0), wx);
    const Vec4 bottom =
        lerp(load_texel(scene, image, x0, y1), load_texel(scene, image, x1, y1), wx);
    return lerp(top, bottom, wy);
}

TP_HD bool is_even_cell(const CheckerRecord& checker, Vec2 uv, Vec3 p) {
    if (checker.mode == CheckerMode::World) {
        return std::sin(checker.frequency * p.x) * std::sin(checker.frequency * p.y) *
                   std::sin(checker.frequency * p.z) >=
               0;
    }
    const Real cell = std::floor(uv.x * checker.cells.x) + std::floor(uv.y * checker.cells.y);
    return cell - 2 * std::floor(cell / 2) == 0;
}

/// An image laid on from the three axes of its space, a unit of it standing for the unit square of
/// uv; the sides are mixed by the powers of the normal's parts.
TP_HD Vec4 sample_triplanar(const SceneView& scene, const ImageRecord& image,
                            const TexturePoint& at) {
    const SpacePoint point = point_in(scene, image.space, at);
    const Vec3 n = abs(point.normal) / max(max_component(abs(point.normal)), Real(1e-30));
    Vec4 sum(0, 0, 0, 0);
    Real weights = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Real weight = std::pow(n[axis], image.sharpness);
        if (!(weight > 0)) continue;
        sum += sample_image(scene, image, plane_coordinates(point.position, point.normal, axis)) *
               weight;
        weights += weight;
    }
    return sum / weights;
}

TP_HD Vec4 image_color(const SceneView& scene, const ImageRecord& image, const TexturePoint& at) {
    return sample_image(scene, image, image.uv_set == 0 ? at.uv : at.uv1) * Vec4(image.tint, 1);
}

/// The colour and alpha of a texture of any kind. Those that mix two colours are walked depth
/// first, the second colours waiting on a stack; validate() bounds it, and what would pass it takes
/// the colour with the larger share.
TP_HD_NOINLINE Vec4 mixed_color(const SceneView& scene, const ColorRef& first,
                                const TexturePoint& at) {
    struct Waiting {
        const ColorRef* ref;
        Real share, shade;  // of the result; of its colour
    };
    Waiting waiting[kMaxBlendNesting];
    int count = 0;
    Waiting now{&first, 1, 1};
    Vec4 sum(0, 0, 0, 0);
    for (;;) {
        Vec4 leaf(now.ref->color, 1);
        if (now.ref->texture >= 0) {
            const TextureRecord& texture = scene.textures[static_cast<uint32_t>(now.ref->texture)];
            switch (texture.kind) {
                case TextureKind::Constant: leaf = Vec4(texture.constant, 1); break;
                case TextureKind::Image:
                    leaf = texture.image.projection == TextureProjection::Triplanar
                               ? sample_triplanar(scene, texture.image, at) *
                                     Vec4(texture.image.tint, 1)
                               : image_color(scene, texture.image, at);
                    break;
                case TextureKind::Checker:
                    now.ref = is_even_cell(texture.checker, at.uv, at.position)
                                  ? &texture.checker.even
                                  : &texture.checker.odd;
                    continue;
                case TextureKind::Noise:
                case TextureKind::Marble:
                case TextureKind::Wood:
                case TextureKind::Brick: {
                    const PatternRecord& r = texture.pattern;
                    PatternMix mix = pattern_mix(scene, texture.kind, r, at);
                    if (count == kMaxBlendNesting) mix.share = mix.share < Real(0.5) ? 0 : 1;
                    if (mix.share >= 1) {
                        now.ref = &r.second;
                        continue;
                    }
                    if (mix.share > 0)
                        waiting[count++] = {&r.second, now.share * mix.share, now.shade};
                    now = {&r.first, now.share * (1 - mix.share), now.shade * mix.shade};
                    continue;
                }
            }
        }
        sum += leaf *
               Vec4(now.share * now.shade, now.share * now.shade, now.share * now.shade, now.share);
        if (count == 0) return sum;
        now = waiting[--count];
    }
}

/// The colour and alpha of a texture. Checkers are walked down to a constant or an image; the
/// reader refuses cycles.
template <uint32_t kFeatures = kFeatureAll>
TP_HD Vec4 color_at(const SceneView& scene, ColorRef ref, const TexturePoint& at) {
    while (ref.texture >= 0) {
        const TextureRecord& texture = scene.textures[static_cast<uint32_t>(ref.texture)];
        if constexpr ((kFeatures & kFeatureProcedural) != 0) {
            const bool is_simple = texture.kind == TextureKind::Constant ||
                                   texture.kind == TextureKind::Checker ||
                                   (texture.kind == TextureKind::Image &&
                                    texture.image.projection == TextureProjection::Uv);
            if (!is_simple) return mixed_color(scene, ref, at);
        }
        if (texture.kind == TextureKind::Image) return image_color(scene, texture.image, at);
        if (texture.kind == TextureKind::Constant) return Vec4(texture.constant, 1);
        ref = is_even_cell(texture.checker, at.uv, at.position) ? texture.checker.even
                                                                : texture.checker.odd;
    }
    return Vec4(ref.color, 1);
}

}  // namespace tp
