// From linear radiance to what a screen shows; the same code for window and file.
#pragma once

#include <teapath/core/color.h>
#include <teapath/kernel/settings.h>

namespace tp {

/// A display value in [0, 1] for `x` after exposure; NaN gives 0.
TP_HD float tone_map(float x, ToneCurve curve) {
    switch (curve) {
        case ToneCurve::Srgb: return srgb_from_linear(x);
        case ToneCurve::Gamma2: return ::sqrtf(fminf(fmaxf(x, 0.0f), 1.0f));
        case ToneCurve::Linear: break;
    }
    return fminf(fmaxf(x, 0.0f), 1.0f);
}

struct Rgb8 {
    uint8_t r, g, b;
};

/// Exposure in stops, the tone curve, then 8 bits rounded to nearest.
TP_HD Rgb8 display_color(Vec3 radiance, const DisplaySettings& display) {
    const float scale = exp2f(display.exposure);
    const auto code = [&](Real x) {
        return static_cast<uint8_t>(
            tone_map(static_cast<float>(x) * scale, display.curve) * 255.0f + 0.5f);
    };
    return {code(radiance.x), code(radiance.y), code(radiance.z)};
}

}  // namespace tp
