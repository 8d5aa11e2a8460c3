#include "split_transform.h"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;

// Angles about x, then y, then z of a rotation.
Double3 euler_degrees(const DoubleMat3& r) {
    const double sine_y = std::clamp(-r[0][2], -1.0, 1.0);
    const double y = std::asin(sine_y);
    if (std::abs(sine_y) > 1 - 1e-12)  // x and z turn about the same axis
        return Double3(std::atan2(-r[2][1], r[1][1]), y, 0) * kDegrees;
    return Double3(std::atan2(r[1][2], r[2][2]), y, std::atan2(r[0][1], r[0][0])) * kDegrees;
}

// Angles and scales from a file of floats: 90.0000025 is meant to be 90.
double tidy(double x, double tolerance) {
    const double rounded = std::round(x * 1e4) / 1e4;
    return std::abs(x - rounded) < tolerance ? rounded + 0.0 : x;
}

bool all_finite(const DoubleMat4& m) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(m[c][r])) return false;
    return true;
}

}  // namespace

std::optional<SplitTransform> split_transform(const DoubleMat4& m) {
    if (!all_finite(m)) return std::nullopt;
    const DoubleMat3 linear(m);

    // Columns = q * upper triangle.
    DoubleMat3 q(1), upper(0);
    double largest = 0;
    for (int c = 0; c < 3; ++c)
        largest = std::max(largest, glm::length(linear[c]));
    for (int c = 0; c < 3; ++c) {
        Double3 rest = linear[c];
        for (int k = 0; k < c; ++k) {
            upper[c][k] = glm::dot(q[k], linear[c]);
            rest -= q[k] * upper[c][k];
        }
        upper[c][c] = glm::length(rest);
        if (!(upper[c][c] > 1e-10 * largest) || !std::isfinite(1 / upper[c][c]))
            return std::nullopt;
        q[c] = rest / upper[c][c];
    }
    if (glm::determinant(q) < 0) {
        q[0] = -q[0];
        for (int c = 0; c < 3; ++c)
            upper[c][0] = -upper[c][0];
    }

    SplitTransform split;
    split.transform.translation = Double3(m[3]);
    bool shears = false;
    for (int k = 0; k < 3; ++k) {
        split.transform.scale[k] = upper[k][k];
        for (int c = k + 1; c < 3; ++c) {
            split.placement[c][k] = upper[c][k] / upper[k][k];
            shears |= std::abs(upper[c][k]) > 1e-6 * std::abs(upper[c][c]);
        }
    }
    split.transform.rotation = euler_degrees(q);
    if (!shears) {
        split.placement = DoubleMat3(1);
        for (int k = 0; k < 3; ++k) {
            const double scale = split.transform.scale[k];
            split.transform.scale[k] = tidy(scale, 1e-6 * std::abs(scale));
            split.transform.rotation[k] = tidy(split.transform.rotation[k], 1e-5);
        }
    }
    return split;
}

}  // namespace tp
