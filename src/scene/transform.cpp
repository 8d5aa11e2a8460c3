#include <teapath/scene/transform.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;

// Rotation by `degrees` about axis 0, 1 or 2; multiples of 90 degrees are exact.
DoubleMat3 rotation_about(int axis, double degrees) {
    const double turn = std::fmod(degrees, 360.0);
    double c = std::cos(turn * 3.14159265358979323846 / 180);
    double s = std::sin(turn * 3.14159265358979323846 / 180);
    if (std::fmod(turn, 90.0) == 0) {
        c = std::round(c);
        s = std::round(s);
    }
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    DoubleMat3 m(1);
    m[j][j] = c;
    m[k][k] = c;
    m[j][k] = s;
    m[k][j] = -s;
    return m;
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

DoubleMat3 linear_part(const Transform& t) {
    DoubleMat3 m = rotation_about(2, t.rotation.z) * rotation_about(1, t.rotation.y) *
                   rotation_about(0, t.rotation.x);
    for (int axis = 0; axis < 3; ++axis)
        m[axis] *= t.scale[axis];
    return m;
}

DoubleMat4 world_from_object(const Transform& t) {
    DoubleMat4 m(linear_part(t));
    m[3] = Double4(t.translation, 1);
    return m;
}

Double3 euler_degrees(const DoubleMat3& m) {
    // m = Rz Ry Rx; m[column][row].
    const double sin_y = std::clamp(-m[0][2], -1.0, 1.0);
    const double y = std::asin(sin_y);
    if (std::abs(sin_y) > 1 - 1e-12) return Double3(std::atan2(-m[2][1], m[1][1]), y, 0) * kDegrees;
    return Double3(std::atan2(m[1][2], m[2][2]), y, std::atan2(m[0][1], m[0][0])) * kDegrees;
}

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
