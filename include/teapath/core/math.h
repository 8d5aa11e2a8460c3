// Vectors and matrices (GLM behind short names) and the scalar helpers of the kernels. Real is the
// kernels' number: float, or double in the test build that measures what float costs. The scene
// document stores doubles (Double3 and so on) whatever Real is.
#pragma once

#include <cstdint>
#include <limits>

#define GLM_FORCE_XYZW_ONLY
#define GLM_FORCE_SILENT_WARNINGS
#include <teapath/core/host_device.h>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace tp {

#if defined(TEAPATH_REAL_DOUBLE)
using Real = double;
#else
using Real = float;
#endif

using Vec2 = glm::vec<2, Real>;
using Vec3 = glm::vec<3, Real>;
using Vec4 = glm::vec<4, Real>;
using Mat3 = glm::mat<3, 3, Real>;  // columns
using Int2 = glm::ivec2;

using Double2 = glm::dvec2;
using Double3 = glm::dvec3;
using Double4 = glm::dvec4;
using DoubleMat3 = glm::dmat3;
using DoubleMat4 = glm::dmat4;
using DoubleQuat = glm::dquat;

inline constexpr Real kPi = Real(3.14159265358979323846);
inline constexpr Real kInvPi = Real(0.31830988618379067154);
inline constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
inline constexpr Real kOneMinusEpsilon = 1 - std::numeric_limits<Real>::epsilon() / 2;
inline constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon() / 2;  // unit roundoff

using glm::cross;
using glm::dot;

template <class T>
TP_HD T min(T a, T b) {
    return a < b ? a : b;
}
template <class T>
TP_HD T max(T a, T b) {
    return a > b ? a : b;
}
template <class T>
TP_HD T clamp(T x, T low, T high) {
    return min(max(x, low), high);
}
template <class T>
TP_HD T sqr(T x) {
    return x * x;
}
template <class T>
TP_HD T lerp(T a, T b, Real t) {
    return a * (1 - t) + b * t;
}

TP_HD float min(float a, float b) {
    return minimum(a, b);
}
TP_HD float max(float a, float b) {
    return maximum(a, b);
}
TP_HD Vec3 min(Vec3 a, Vec3 b) {
    return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)};
}
TP_HD Vec3 max(Vec3 a, Vec3 b) {
    return {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)};
}
TP_HD float abs(float x) {
    return fabsf(x);
}
TP_HD double abs(double x) {
    return fabs(x);
}
TP_HD Vec3 abs(Vec3 a) {
    return {abs(a.x), abs(a.y), abs(a.z)};
}
TP_HD float sqrt(float x) {
    return ::sqrtf(x);
}
TP_HD double sqrt(double x) {
    return ::sqrt(x);
}
TP_HD Real safe_sqrt(Real x) {
    return tp::sqrt(max(x, Real(0)));
}
TP_HD Real max_component(Vec3 a) {
    return max(a.x, max(a.y, a.z));
}
TP_HD Real min_component(Vec3 a) {
    return min(a.x, min(a.y, a.z));
}
TP_HD Real length_squared(Vec3 a) {
    return dot(a, a);
}
TP_HD Real length(Vec3 a) {
    return tp::sqrt(dot(a, a));
}
TP_HD Vec3 normalize(Vec3 a) {
    return a * tp::rsqrt(dot(a, a));
}
TP_HD bool is_black(Vec3 a) {
    return a.x == 0 && a.y == 0 && a.z == 0;
}
TP_HD bool is_finite(Vec3 a) {
    // Inf - Inf and NaN - NaN are NaN, which is equal to nothing.
    return a.x - a.x == 0 && a.y - a.y == 0 && a.z - a.z == 0;
}

}  // namespace tp
