// Tone curves: from linear radiance of any height to linear colour in [0, 1]. Each works on
// colours, not on channels, where its source does.
#pragma once

#include <teapath/core/math.h>

namespace tp {

/// Narkowicz, "ACES Filmic Tone Mapping Curve", 2016: a rational fit per channel.
TP_HD float aces_curve(float x) {
    const float y = x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
    return fminf(fmaxf(y, 0.0f), 1.0f);
}

/// Khronos PBR Neutral (specification of the glTF tone mapper, 2024): exact below 0.8, minus the 4
/// % that a dielectric reflects; above it peaks are compressed and desaturated.
TP_HD Vec3 neutral_curve(Vec3 c) {
    constexpr Real kStart = Real(0.8 - 0.04), kDesaturation = Real(0.15);
    const Real low = min(c.x, min(c.y, c.z));
    const Real offset = low < Real(0.08) ? low - Real(6.25) * low * low : Real(0.04);
    c -= Vec3(offset, offset, offset);
    const Real peak = max_component(c);
    if (peak < kStart) return c;
    constexpr Real kRoom = 1 - kStart;
    const Real new_peak = 1 - kRoom * kRoom / (peak + kRoom - kStart);
    c *= new_peak / peak;
    const Real grey = 1 - 1 / (kDesaturation * (peak - new_peak) + 1);
    return c * (1 - grey) + Vec3(new_peak, new_peak, new_peak) * grey;
}

/// Sobotka's AgX in Wrensch's form ("Minimal AgX", 2023): into a wider space, logarithm of 16.5
/// stops, a polynomial for its sigmoid, back. The result is linear: the curve's own display
/// exponent of 2.2 is taken out.
TP_HD Vec3 agx_curve(Vec3 c) {
    constexpr float kLowest = -12.47393f, kHighest = 4.026069f;
    const auto sigmoid = [&](Real linear) {
        const float x = fmaxf(static_cast<float>(linear), 1e-10f);
        const float t =
            (fminf(fmaxf(log2f(x), kLowest), kHighest) - kLowest) / (kHighest - kLowest);
        const float t2 = t * t, t4 = t2 * t2;
        return static_cast<Real>(15.5f * t4 * t2 - 40.14f * t4 * t + 31.96f * t4 - 6.868f * t2 * t +
                                 0.4298f * t2 + 0.1191f * t - 0.00232f);
    };
    const Vec3 inset =
        Vec3(Real(0.842479062253094), Real(0.0423282422610123), Real(0.0423756549057051)) * c.x +
        Vec3(Real(0.0784335999999992), Real(0.878468636469772), Real(0.0784336)) * c.y +
        Vec3(Real(0.0792237451477643), Real(0.0791661274605434), Real(0.879142973793104)) * c.z;
    const Vec3 s{sigmoid(inset.x), sigmoid(inset.y), sigmoid(inset.z)};
    const Vec3 out =
        Vec3(Real(1.19687900512017), Real(-0.0528968517574562), Real(-0.0529716355144438)) * s.x +
        Vec3(Real(-0.0980208811401368), Real(1.15190312990417), Real(-0.0980434501171241)) * s.y +
        Vec3(Real(-0.0990297440797205), Real(-0.0989611768448433), Real(1.15107367264116)) * s.z;
    const auto linear = [](Real x) {
        return static_cast<Real>(powf(fminf(fmaxf(static_cast<float>(x), 0.0f), 1.0f), 2.2f));
    };
    return {linear(out.x), linear(out.y), linear(out.z)};
}

}  // namespace tp
