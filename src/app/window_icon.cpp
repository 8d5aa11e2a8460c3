#include "window_icon.h"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

struct Ink {
    float r, g, b, a;
};
constexpr Ink kNone{0, 0, 0, 0}, kGround{30, 30, 32, 1}, kTea{232, 163, 61, 1},
    kCup{236, 236, 236, 1}, kSteam{150, 150, 152, 1};

bool in_rounded_square(float x, float y, float half, float radius) {
    const float dx = std::max(0.0f, std::fabs(x) - (half - radius));
    const float dy = std::max(0.0f, std::fabs(y) - (half - radius));
    return dx * dx + dy * dy <= radius * radius;
}

bool in_ellipse(float x, float y, float cx, float cy, float rx, float ry) {
    const float dx = (x - cx) / rx, dy = (y - cy) / ry;
    return dx * dx + dy * dy <= 1;
}

// What is at a point of [-1, 1]^2, y downwards.
Ink ink_at(float x, float y) {
    if (!in_rounded_square(x, y, 0.98f, 0.42f)) return kNone;
    if (in_ellipse(x, y, -0.08f, -0.02f, 0.46f, 0.13f)) return kTea;
    if (in_ellipse(x, y, -0.08f, -0.02f, 0.56f, 0.2f)) return kCup;
    // Body: a half ellipse below the rim; handle: a ring at its right.
    if (y > -0.02f && in_ellipse(x, y, -0.08f, -0.02f, 0.56f, 0.66f)) return kCup;
    if (in_ellipse(x, y, 0.46f, 0.18f, 0.28f, 0.26f) &&
        !in_ellipse(x, y, 0.46f, 0.18f, 0.15f, 0.14f))
        return kCup;
    for (const float at : {-0.3f, -0.06f, 0.18f})
        if (y > -0.72f && y < -0.34f && std::fabs(x - at - 0.06f * std::sin(9 * y)) < 0.045f)
            return kSteam;
    return kGround;
}

}  // namespace

std::vector<uint8_t> window_icon(int size) {
    constexpr int kSamples = 4;  // along each axis
    std::vector<uint8_t> pixels;
    pixels.reserve(4 * static_cast<size_t>(size) * static_cast<size_t>(size));
    const float step = 2.0f / static_cast<float>(size * kSamples);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            Ink sum = kNone;
            for (int s = 0; s < kSamples * kSamples; ++s) {
                const auto sx = static_cast<float>(x * kSamples + s % kSamples) + 0.5f;
                const auto sy = static_cast<float>(y * kSamples + s / kSamples) + 0.5f;
                const Ink ink = ink_at(sx * step - 1, sy * step - 1);
                sum = {sum.r + ink.r * ink.a, sum.g + ink.g * ink.a, sum.b + ink.b * ink.a,
                       sum.a + ink.a};
            }
            const float weight = sum.a > 0 ? 1 / sum.a : 0;
            for (const float channel : {sum.r * weight, sum.g * weight, sum.b * weight,
                                        255 * sum.a / (kSamples * kSamples)})
                pixels.push_back(static_cast<uint8_t>(channel + 0.5f));
        }
    return pixels;
}

}  // namespace tp
