// Every warp against its density, by chi-squared tests; AC-F3's moments.
#include "support/chi2.h"

#include <teapath/core/tea.h>
#include <teapath/kernel/bsdf/lambertian.h>
#include <teapath/kernel/warps.h>

#include <doctest/doctest.h>

#include <initializer_list>

using namespace tp;
using namespace tp::test;

namespace {

constexpr int kSamples = 400000;
constexpr int kTests = 16;

Vec2 uniform2(int i, uint32_t stream = 0) {
    const TeaBlock b = tea_encrypt<8>({static_cast<uint32_t>(i), stream}, tea_key(0, 99));
    return {unit_real(b.v0), unit_real(b.v1)};
}
Real uniform1(int i) {
    return uniform2(i, 77).x;
}

double p_of(const std::function<Vec3(int)>& sample, const std::function<double(const Vec3&)>& pdf,
            SphereBins bins = {}) {
    return chi2_directions<Vec3>(sample, pdf, kSamples, bins);
}

}  // namespace

TEST_CASE("the chi-squared tail has its textbook values") {
    CHECK(chi2_tail(3.841, 1) == doctest::Approx(0.05).epsilon(0.001));
    CHECK(chi2_tail(124.342, 100) == doctest::Approx(0.05).epsilon(0.001));
    CHECK(chi2_tail(149.449, 100) == doctest::Approx(0.001).epsilon(0.002));
}

TEST_CASE("directions: hemisphere, sphere, cosine and cone") {
    CHECK(p_of([](int i) { return sample_cosine_hemisphere(uniform2(i)); },
               [](const Vec3& d) { return static_cast<double>(cosine_hemisphere_pdf(d.z)); }) >
          sidak(kTests));
    CHECK(p_of([](int i) { return sample_uniform_hemisphere(uniform2(i)); },
               [](const Vec3& d) {
                   return d.z > 0 ? static_cast<double>(uniform_hemisphere_pdf()) : 0;
               }) > sidak(kTests));
    CHECK(p_of([](int i) { return sample_uniform_sphere(uniform2(i)); },
               [](const Vec3&) { return static_cast<double>(uniform_sphere_pdf()); }) >
          sidak(kTests));
    // A cone whose rim falls between rows of bins.
    const Real cone = Real(0.3);
    CHECK(p_of([&](int i) { return sample_uniform_cone(uniform2(i), cone); },
               [&](const Vec3& d) {
                   return d.z > 1 - cone ? static_cast<double>(uniform_cone_pdf(cone)) : 0;
               }) > sidak(kTests));
    // The test itself can fail: a wrong density is seen.
    CHECK(p_of([](int i) { return sample_uniform_hemisphere(uniform2(i)); },
               [](const Vec3& d) { return static_cast<double>(cosine_hemisphere_pdf(d.z)); }) <
          1e-6);
}

TEST_CASE("a tiny cone keeps its precision") {
    const Real cone = Real(1e-10);  // half angle 1.4e-5
    double mean_share = 0;
    for (int i = 0; i < 10000; ++i) {
        const Vec3 d = sample_uniform_cone(uniform2(i), cone);
        const double r = std::hypot(static_cast<double>(d.x), static_cast<double>(d.y));
        CHECK(r <= std::sqrt(2e-10) * 1.0001);
        mean_share += r * r / 2e-10 / 10000;  // uniform in the square of the radius
    }
    CHECK(mean_share == doctest::Approx(0.5).epsilon(0.02));
}

TEST_CASE("the metal's lobe: a point in a ball around the axis, seen from the origin") {
    for (const double radius : {0.05, 0.3, 0.7, 1.0}) {
        CAPTURE(radius);
        const auto r = static_cast<Real>(radius);
        const Vec3 axis = normalize(Vec3(Double3(0.3, -0.5, 0.8)));
        SphereBins bins;
        // The density falls steeply at the rim: cells small enough for the midpoint rule.
        if (radius < 0.5) bins = {160, 320};
        CHECK(p_of([&](int i) { return sample_fuzz_lobe(axis, r, uniform2(i), uniform1(i)); },
                   [&](const Vec3& d) { return static_cast<double>(fuzz_lobe_pdf(axis, r, d)); },
                   bins) > sidak(kTests));
    }
}

TEST_CASE("disk and triangle are uniform") {
    std::vector<double> disk(400, 0), triangle(400, 0), disk_expected(400, 0),
        triangle_expected(400, 0);
    const auto cell = [](double x, double y) {
        return static_cast<size_t>(std::clamp(static_cast<int>(x * 20), 0, 19) * 20 +
                                   std::clamp(static_cast<int>(y * 20), 0, 19));
    };
    for (int i = 0; i < kSamples; ++i) {
        const Vec2 d = sample_uniform_disk(uniform2(i)), t = sample_uniform_triangle(uniform2(i));
        disk[cell((static_cast<double>(d.x) + 1) / 2, (static_cast<double>(d.y) + 1) / 2)] += 1;
        triangle[cell(static_cast<double>(t.x), static_cast<double>(t.y))] += 1;
    }
    constexpr int kGrid = 2000;
    double in_disk = 0, in_triangle = 0;
    for (int i = 0; i < kGrid; ++i)
        for (int j = 0; j < kGrid; ++j) {
            const double x = (i + 0.5) / kGrid, y = (j + 0.5) / kGrid;
            if (std::hypot(2 * x - 1, 2 * y - 1) <= 1) disk_expected[cell(x, y)] += 1, ++in_disk;
            if (x + y <= 1) triangle_expected[cell(x, y)] += 1, ++in_triangle;
        }
    for (size_t i = 0; i < 400; ++i) {
        disk_expected[i] *= kSamples / in_disk;
        triangle_expected[i] *= kSamples / in_triangle;
    }
    CHECK(chi2_p_value(disk, disk_expected) > sidak(kTests));
    CHECK(chi2_p_value(triangle, triangle_expected) > sidak(kTests));
}

TEST_CASE("the ball is uniform: the cube of the radius is") {
    std::vector<double> observed(50, 0), expected(50, kSamples / 50.0);
    for (int i = 0; i < kSamples; ++i) {
        const double r = static_cast<double>(length(sample_uniform_ball(uniform2(i), uniform1(i))));
        observed[static_cast<size_t>(std::min(49.0, r * r * r * 50))] += 1;
    }
    CHECK(chi2_p_value(observed, expected) > sidak(kTests));
}

TEST_CASE("AC-F3: mean cosines tell the scatter rules apart") {
    const auto moments = [](ScatterRule rule) {
        double mean = 0, square = 0;
        const Vec3 normal = normalize(Vec3(Double3(0.2, 0.9, -0.4)));
        constexpr int n = 2000000;
        for (int i = 0; i < n; ++i) {
            const double c = static_cast<double>(
                dot(lambertian_sample_by_rule(rule, Vec3(1), normal, uniform2(i), uniform1(i)).wi,
                    normal));
            mean += c / n;
            square += c * c / n;
        }
        return std::pair{mean, square};
    };
    const auto [mean, square] = moments(ScatterRule::Cosine);
    CHECK(std::abs(mean - 2.0 / 3) < 0.0005);
    CHECK(std::abs(square - 0.5) < 0.0005);
    CHECK(std::abs(moments(ScatterRule::CosineCubed).first - 0.8) < 0.0005);
    CHECK(std::abs(moments(ScatterRule::Hemisphere).first - 0.5) < 0.0005);
}
