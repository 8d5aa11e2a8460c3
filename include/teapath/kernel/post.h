// From linear radiance to what a screen shows; the same code for window and file.
#pragma once

#include <teapath/core/color.h>
#include <teapath/kernel/settings.h>
#include <teapath/kernel/tone_curves.h>

namespace tp {

/// A display value in [0, 1] of each channel for a colour after exposure; NaN gives 0.
TP_HD Vec3 tone_map(Vec3 c, ToneCurve curve) {
    const auto unit = [](Real x) { return fminf(fmaxf(static_cast<float>(x), 0.0f), 1.0f); };
    switch (curve) {
        case ToneCurve::Linear: return {unit(c.x), unit(c.y), unit(c.z)};
        case ToneCurve::Gamma2: return {sqrtf(unit(c.x)), sqrtf(unit(c.y)), sqrtf(unit(c.z))};
        case ToneCurve::Aces:
            c = {aces_curve(static_cast<float>(c.x)), aces_curve(static_cast<float>(c.y)),
                 aces_curve(static_cast<float>(c.z))};
            break;
        case ToneCurve::Agx: c = agx_curve(c); break;
        case ToneCurve::Neutral: c = neutral_curve(c); break;
        case ToneCurve::Srgb: break;
    }
    return {srgb_from_linear(static_cast<float>(c.x)), srgb_from_linear(static_cast<float>(c.y)),
            srgb_from_linear(static_cast<float>(c.z))};
}

struct Rgb8 {
    uint8_t r, g, b;
};

/// What radiance is multiplied by. An exposure value puts white at 1.2 * 2^EV (ISO 12232 by its
/// saturation speed, for a lens that passes 0.65 and a sensor that is full at 0.78).
TP_HD float exposure_scale(const DisplaySettings& display) {
    float ev = display.ev;
    if (display.rule == ExposureRule::Stops) return exp2f(display.exposure);
    if (display.rule == ExposureRule::Photo)
        ev = log2f(display.f_number * display.f_number / display.shutter * 100 / display.iso);
    return exp2f(display.exposure - ev) / 1.2f;
}

/// Exposure, the tone curve, then 8 bits rounded to nearest.
TP_HD Rgb8 display_color(Vec3 radiance, const DisplaySettings& display) {
    const Vec3 c = tone_map(radiance * static_cast<Real>(exposure_scale(display)), display.curve);
    const auto code = [](Real x) {
        return static_cast<uint8_t>(static_cast<float>(x) * 255.0f + 0.5f);
    };
    return {code(c.x), code(c.y), code(c.z)};
}

/// Four bytes a pixel, as a GL texture of RGBA8 holds them; opaque.
struct alignas(4) Rgba8 {
    uint8_t r, g, b, a;
};
TP_HD Rgba8 opaque(Rgb8 c) {
    return {c.r, c.g, c.b, 255};
}

}  // namespace tp
