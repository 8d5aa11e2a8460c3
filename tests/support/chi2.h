// Goodness of fit of samples to a density: Pearson's chi-squared over bins of the sphere or plane.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace tp::test {

/// Upper tail of the chi-squared distribution: the regularised incomplete gamma function
/// Q(k / 2, x / 2), by series or continued fraction (Abramowitz and Stegun 6.5.29, 6.5.31).
inline double chi2_tail(double x, double k) {
    const double a = k / 2, y = x / 2;
    if (y <= 0) return 1;
    const double front = std::exp(-y + a * std::log(y) - std::lgamma(a));
    if (y < a + 1) {
        double term = 1 / a, sum = term;
        for (int n = 1; n < 10000 && term > sum * 1e-15; ++n)
            sum += term *= y / (a + n);
        return 1 - front * sum;
    }
    double b = y + 1 - a, c = 1e300, d = 1 / b, h = d;
    for (int n = 1; n < 10000; ++n) {
        const double an = -n * (n - a);
        b += 2;
        d = 1 / (an * d + b);
        c = b + an / c;
        const double delta = d * c;
        h *= delta;
        if (std::abs(delta - 1) < 1e-15) break;
    }
    return front * h;
}

/// p-value of observed counts against expected ones; bins that expect few are pooled.
inline double chi2_p_value(const std::vector<double>& observed,
                           const std::vector<double>& expected) {
    constexpr double kFewest = 8;
    std::vector<size_t> order(observed.size());
    for (size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](size_t a, size_t b) { return expected[a] < expected[b]; });
    double statistic = 0, pooled_observed = 0, pooled_expected = 0;
    int bins = 0;
    for (const size_t i : order) {
        pooled_observed += observed[i];
        pooled_expected += expected[i];
        if (pooled_expected < kFewest) continue;
        statistic += (pooled_observed - pooled_expected) * (pooled_observed - pooled_expected) /
                     pooled_expected;
        ++bins;
        pooled_observed = pooled_expected = 0;
    }
    // What cannot happen must not: anything left over that was expected nowhere fails.
    if (pooled_expected < 1e-9 && pooled_observed > 0) return 0;
    return bins > 1 ? chi2_tail(statistic, bins - 1) : 1;
}

/// A grid of equal-area cells over the sphere: `rows` in z, `columns` in azimuth.
struct SphereBins {
    int rows = 20, columns = 40;

    size_t count() const { return static_cast<size_t>(rows) * static_cast<size_t>(columns); }
    template <class Vector>
    size_t bin_of(const Vector& d) const {
        const int row =
            std::clamp(static_cast<int>((static_cast<double>(d.z) + 1) / 2 * rows), 0, rows - 1);
        const double azimuth =
            std::atan2(static_cast<double>(d.y), static_cast<double>(d.x)) / 6.283185307179586 +
            0.5;
        const int column = std::clamp(static_cast<int>(azimuth * columns), 0, columns - 1);
        return static_cast<size_t>(row) * static_cast<size_t>(columns) +
               static_cast<size_t>(column);
    }
    /// The integral of `pdf` over each cell, by the midpoint rule on `steps`^2 points.
    template <class Vector>
    std::vector<double> integrate(const std::function<double(const Vector&)>& pdf,
                                  int steps = 24) const {
        std::vector<double> mass(count(), 0);
        const double cell = 12.566370614359172 / static_cast<double>(count()) / (steps * steps);
        for (int i = 0; i < rows * steps; ++i) {
            const double z = -1 + 2 * (i + 0.5) / (rows * steps), r = std::sqrt(1 - z * z);
            for (int j = 0; j < columns * steps; ++j) {
                const double phi = ((j + 0.5) / (columns * steps) - 0.5) * 6.283185307179586;
                Vector d;
                d.x = static_cast<decltype(d.x)>(r * std::cos(phi));
                d.y = static_cast<decltype(d.x)>(r * std::sin(phi));
                d.z = static_cast<decltype(d.x)>(z);
                mass[static_cast<size_t>(i / steps) * static_cast<size_t>(columns) +
                     static_cast<size_t>(j / steps)] += pdf(d) * cell;
            }
        }
        return mass;
    }
};

/// p-value of directions from `sample` (called `n` times) against `pdf` over solid angle; `sample`
/// may return a zero vector for an absorbed sample, whose share is what the pdf lacks to 1.
template <class Vector>
double chi2_directions(const std::function<Vector(int)>& sample,
                       const std::function<double(const Vector&)>& pdf, int n,
                       SphereBins bins = {}) {
    std::vector<double> observed(bins.count() + 1, 0), expected = bins.integrate<Vector>(pdf);
    double total = 0;
    for (const double mass : expected)
        total += mass;
    expected.push_back(std::max(0.0, 1 - total));
    for (double& mass : expected)
        mass *= n;
    for (int i = 0; i < n; ++i) {
        const Vector d = sample(i);
        const bool absorbed = d.x == 0 && d.y == 0 && d.z == 0;
        observed[absorbed ? bins.count() : bins.bin_of(d)] += 1;
    }
    return chi2_p_value(observed, expected);
}

/// The p-value below which one of `tests` independent tests may be taken to fail, at 0.1 % over all
/// (Sidak).
inline double sidak(int tests) {
    return 1 - std::pow(1 - 0.001, 1.0 / tests);
}

}  // namespace tp::test
