#include <teapath/scene/animation.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

// Two keyframes and where a time lies between them.
struct Interval {
    size_t first = 0, second = 0;
    double share = 0;   // 0 at the first, 1 at the second
    double length = 0;  // seconds
};

Interval interval_at(const std::vector<float>& times, double time) {
    const auto after = std::upper_bound(times.begin(), times.end(), time, [](double t, float key) {
        return t < static_cast<double>(key);
    });
    if (after == times.begin()) return {};
    const auto second = static_cast<size_t>(after - times.begin());
    if (after == times.end()) return {second - 1, second - 1, 0, 0};
    const double start = static_cast<double>(times[second - 1]);
    const double length = static_cast<double>(times[second]) - start;
    return {second - 1, second, (time - start) / length, length};
}

// The n-th of three numbers that a cubic keyframe has for each component: 0 towards it, 1 its
// value, 2 from it. Other keyframes have only their value.
double number_of(const AnimationSampler& s, size_t keyframe, size_t n, size_t component) {
    const bool is_cubic = s.interpolation == Interpolation::CubicSpline;
    const size_t row = is_cubic ? 3 * keyframe + n : keyframe;
    return static_cast<double>(s.values[row * s.width + component]);
}

// Hermite's polynomials with tangents by second (glTF 2.0, appendix C.4).
double cubic(const AnimationSampler& s, const Interval& at, size_t component) {
    const double t = at.share, t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * number_of(s, at.first, 1, component) +
           at.length * (t3 - 2 * t2 + t) * number_of(s, at.first, 2, component) +
           (3 * t2 - 2 * t3) * number_of(s, at.second, 1, component) +
           at.length * (t3 - t2) * number_of(s, at.second, 0, component);
}

double value_at(const AnimationSampler& s, const Interval& at, size_t component) {
    const double first = number_of(s, at.first, 1, component);
    if (at.first == at.second || s.interpolation == Interpolation::Step) return first;
    if (s.interpolation == Interpolation::CubicSpline) return cubic(s, at, component);
    return first + (number_of(s, at.second, 1, component) - first) * at.share;
}

Double4 unit(Double4 q) {
    const double length = glm::length(q);
    return length > 0 && std::isfinite(length) ? q / length : Double4(0, 0, 0, 1);
}

Double4 slerp(Double4 a, Double4 b, double share) {
    double cosine = glm::dot(a, b);
    if (cosine < 0) {  // q and -q are one rotation: the shorter way
        b = -b;
        cosine = -cosine;
    }
    constexpr double kNearlyOne = 1 - 1e-9;
    if (cosine > kNearlyOne) return unit(a + (b - a) * share);
    const double angle = std::acos(cosine);
    return (a * std::sin((1 - share) * angle) + b * std::sin(share * angle)) / std::sin(angle);
}

// Glm's own quaternion type has its members in either order, by its version.
DoubleMat3 rotation_of(Double4 q) {
    const double l2 = glm::dot(q, q);
    if (!(l2 > 0) || !std::isfinite(l2)) return DoubleMat3(1);
    const double s = 2 / l2;
    const double x = q.x, y = q.y, z = q.z, w = q.w;
    return {1 - s * (y * y + z * z), s * (x * y + w * z),     s * (x * z - w * y),
            s * (x * y - w * z),     1 - s * (x * x + z * z), s * (y * z + w * x),
            s * (x * z + w * y),     s * (y * z - w * x),     1 - s * (x * x + y * y)};
}

}  // namespace

std::vector<double> sample_numbers(const AnimationSampler& sampler, double time) {
    const Interval at = interval_at(sampler.times, time);
    std::vector<double> numbers(sampler.width);
    for (size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = value_at(sampler, at, i);
    return numbers;
}

Double3 sample_vector(const AnimationSampler& sampler, double time) {
    const Interval at = interval_at(sampler.times, time);
    return {value_at(sampler, at, 0), value_at(sampler, at, 1), value_at(sampler, at, 2)};
}

Double4 sample_rotation(const AnimationSampler& sampler, double time) {
    const Interval at = interval_at(sampler.times, time);
    const auto keyframe = [&](size_t i) {
        return unit({number_of(sampler, i, 1, 0), number_of(sampler, i, 1, 1),
                     number_of(sampler, i, 1, 2), number_of(sampler, i, 1, 3)});
    };
    if (at.first == at.second || sampler.interpolation == Interpolation::Step)
        return keyframe(at.first);
    if (sampler.interpolation == Interpolation::Linear)
        return slerp(keyframe(at.first), keyframe(at.second), at.share);
    return unit({cubic(sampler, at, 0), cubic(sampler, at, 1), cubic(sampler, at, 2),
                 cubic(sampler, at, 3)});
}

DoubleMat4 placement_matrix(Double3 translation, Double4 rotation, Double3 scale) {
    const DoubleMat3 turn = rotation_of(rotation);
    DoubleMat4 m(1);
    for (int c = 0; c < 3; ++c)
        m[c] = Double4(turn[c] * scale[c], 0);
    m[3] = Double4(translation, 1);
    return m;
}

}  // namespace tp
