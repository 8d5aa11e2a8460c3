// Colour: Rec. 709 luminance and the sRGB transfer curve (IEC 61966-2-1).
#pragma once

#include <teapath/core/math.h>

namespace tp {

/// Luminance Y of a linear Rec. 709 colour.
TP_HD Real luminance(Vec3 c) {
    return Real(0.2126390) * c.x + Real(0.7151687) * c.y + Real(0.0721923) * c.z;
}

/// sRGB's code value in [0, 1] for a linear value; inputs are clamped to [0, 1], NaN gives 0.
TP_HD float srgb_from_linear(float x) {
    x = fminf(fmaxf(x, 0.0f), 1.0f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * powf(x, 1.0f / 2.4f) - 0.055f;
}

/// The linear value of an sRGB code value in [0, 1].
TP_HD float linear_from_srgb(float x) {
    return x <= 0.04045f ? x / 12.92f : powf((x + 0.055f) / 1.055f, 2.4f);
}

}  // namespace tp
