// Chi-squared tests of samplers against their densities: a grid of cells over directions, the
// density's integral per cell, cells that expect little pooled, a p-value.
#pragma once

#include <teapath/core/frame.h>
#include <teapath/core/tea.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tp::test {

/// The upper regularised incomplete gamma function Q(a, x): series below, continued fraction above
/// x = a + 1.
inline double incomplete_gamma_q(double a, double x) {
    if (x <= 0) return 1;
    const double scale = std::exp(a * std::log(x) - x - std::lgamma(a));
    if (x < a + 1) {
        double term = 1 / a, sum = term;
        for (int n = 1; n < 100000 && term > sum * 1e-15; ++n)
            sum += term *= x / (a + n);
        return 1 - scale * sum;
    }
    // Lentz's algorithm.
    double b = x + 1 - a, c = 1e300, d = 1 / b, fraction = d;
    for (int n = 1; n < 100000; ++n) {
        const double numerator = -n * (n - a);
        b += 2;
        d = 1 / (numerator * d + b);
        c = b + numerator / c;
        fraction *= c * d;
        if (std::abs(c * d - 1) < 1e-15) break;
    }
    return scale * fraction;
}

/// How often chi squared with `degrees` degrees of freedom is at least `chi2`.
inline double chi2_p_value(double chi2, int degrees) {
    return degrees <= 0 ? 1 : incomplete_gamma_q(degrees / 2.0, chi2 / 2);
}

/// The level of each of `tests` independent tests that all pass with probability 1 - `level`.
inline double sidak(double level, int tests) {
    return 1 - std::pow(1 - level, 1.0 / tests);
}

struct Chi2 {
    double statistic = 0;
    int degrees = -1;
    double p_value = 0;
    double impossible = 0;  // samples where the density is zero
};

/// Observed counts against expected ones. Cells are pooled, smallest first, until each pool expects
/// at least `least`.
inline Chi2 chi2_test(const std::vector<double>& observed, const std::vector<double>& expected,
                      double least = 5) {
    std::vector<size_t> order(expected.size());
    for (size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](size_t a, size_t b) { return expected[a] < expected[b]; });
    Chi2 result;
    double pool_observed = 0, pool_expected = 0;
    for (const size_t i : order) {
        if (expected[i] <= 0) {
            result.impossible += observed[i];
            continue;
        }
        pool_observed += observed[i];
        pool_expected += expected[i];
        if (pool_expected < least) continue;
        const double difference = pool_observed - pool_expected;
        result.statistic += difference * difference / pool_expected;
        ++result.degrees;
        pool_observed = pool_expected = 0;
    }
    result.p_value = chi2_p_value(result.statistic, result.degrees);
    return result;
}

/// Chi squared of cells that are all alike.
inline Chi2 chi2_test_uniform(const std::vector<double>& observed) {
    double sum = 0;
    for (const double n : observed)
        sum += n;
    const std::vector<double> expected(observed.size(), sum / double(observed.size()));
    return chi2_test(observed, expected);
}

/// Cells of equal solid angle over the cap of directions d with 1 - dot(axis, d) < depth: depth 2
/// is the sphere, 1 the hemisphere. Depth, not height, keeps its precision in a tiny cap.
class DirectionGrid {
public:
    DirectionGrid(Vec3 axis, double depth, int rows = 16, int columns = 32)
        : frame_(frame_around(axis)), depth_(depth), rows_(rows), columns_(columns) {}

    /// Number of cells in the cap; as an index, what lies outside of it.
    size_t outside() const { return static_cast<size_t>(rows_ * columns_); }

    size_t cell(Vec3 direction) const {
        const Double3 d(direction);
        const double x = glm::dot(d, Double3(frame_.x)), y = glm::dot(d, Double3(frame_.y)),
                     z = glm::dot(d, Double3(frame_.z));
        const double depth = z > 0 ? (x * x + y * y) / (1 + z) : 1 - z;
        double turn = std::atan2(y, x) / (2 * 3.14159265358979323846);
        if (turn < 0) turn += 1;
        // Rounding may carry a sample over the rim of the cap by a few parts in a million.
        if (depth > depth_ * (1 + 4e-6)) return outside();
        const int row = std::min(static_cast<int>(depth / depth_ * rows_), rows_ - 1);
        const int column = std::min(static_cast<int>(turn * columns_), columns_ - 1);
        return static_cast<size_t>(row * columns_ + column);
    }

    /// The integral over each cell of f(direction), a function over solid angle.
    template <class F>
    std::vector<double> integrate(F&& f, int steps = 24) const {
        std::vector<double> cells(outside());
        const double area = depth_ / rows_ * (2 * 3.14159265358979323846 / columns_);
        for (int row = 0; row < rows_ * steps; ++row) {
            for (int column = 0; column < columns_ * steps; ++column) {
                const Vec3 d =
                    direction((row + 0.5) / (rows_ * steps), (column + 0.5) / (columns_ * steps));
                const int cell = row / steps * columns_ + column / steps;
                cells[static_cast<size_t>(cell)] += double(f(d)) * area / (steps * steps);
            }
        }
        return cells;
    }

private:
    Vec3 direction(double row, double column) const {
        const double depth = row * depth_, angle = column * 2 * 3.14159265358979323846;
        const double r = std::sqrt(depth * (2 - depth));
        return frame_.to_world({static_cast<Real>(r * std::cos(angle)),
                                static_cast<Real>(r * std::sin(angle)),
                                static_cast<Real>(1 - depth)});
    }

    Frame frame_;
    double depth_;
    int rows_, columns_;
};

/// `samples` directions of sample(u, u3) against pdf(direction). A sample of length zero was
/// absorbed; it and what the grid leaves out make up what the density lacks to 1, which is returned
/// in `lost` as (counted share, expected share). A density with edges needs more `steps` of a cell.
template <class Sample, class Pdf>
Chi2 chi2_test_directions(const DirectionGrid& grid, uint32_t samples, Sample&& sample, Pdf&& pdf,
                          double (*lost)[2] = nullptr, int steps = 24) {
    std::vector<double> observed(grid.outside() + 1);
    const TeaKey key = tea_key(0, 20);
    for (uint32_t i = 0; i < samples; ++i) {
        const TeaBlock a = tea_encrypt<8>({i, 0}, key), b = tea_encrypt<8>({i, 1}, key);
        const Vec3 d = sample(Vec2{unit_real(a.v0), unit_real(a.v1)}, unit_real(b.v0));
        ++observed[is_black(d) ? grid.outside() : grid.cell(d)];
    }
    std::vector<double> expected = grid.integrate(pdf, steps);
    double sum = 0;
    for (double& n : expected) {
        sum += n;
        n *= samples;
    }
    const double rest = 1 - sum;
    if (lost) {
        (*lost)[0] = observed.back() / samples;
        (*lost)[1] = rest;
    }
    // What is left by the error of integration alone is no cell.
    expected.push_back(rest > 1e-3 ? rest * samples : 0);
    return chi2_test(observed, expected);
}

}  // namespace tp::test
