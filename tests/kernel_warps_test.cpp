// Every map from the unit square against its density, by chi squared.
#include "support/chi2.h"

#include <teapath/kernel/warps.h>

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace tp;
using namespace tp::test;

namespace {

constexpr uint32_t kSamples = 200000;
const double kLevel = sidak(0.01, 24);  // of each test in this file

double square(double x) {
    return x * x;
}

// Calls f(u, u3) for kSamples random numbers.
template <class F>
void for_numbers(F&& f) {
    const TeaKey key = tea_key(0, 7);
    for (uint32_t i = 0; i < kSamples; ++i) {
        const TeaBlock a = tea_encrypt<8>({i, 0}, key), b = tea_encrypt<8>({i, 1}, key);
        f(Vec2{unit_real(a.v0), unit_real(a.v1)}, unit_real(b.v0));
    }
}

int slot(double x, int count) {
    return std::clamp(static_cast<int>(x * count), 0, count - 1);
}

double turn_of(double x, double y) {
    const double turn = std::atan2(y, x) / (2 * 3.14159265358979323846);
    return turn < 0 ? turn + 1 : turn;
}

template <class Sample, class Pdf>
void check_directions(double depth, Sample&& sample, Pdf&& pdf, Vec3 axis = {0, 0, 1}) {
    double lost[2];
    const Chi2 chi2 =
        chi2_test_directions(DirectionGrid(axis, depth), kSamples, sample, pdf, &lost);
    CAPTURE(chi2.statistic);
    CAPTURE(chi2.degrees);
    CHECK(chi2.p_value > kLevel);
    CHECK(chi2.impossible == 0);
    CHECK(std::abs(lost[1]) < 1e-3);  // the density integrates to 1
}

}  // namespace

TEST_CASE("chi squared has the tabulated quantiles, and finds a wrong density") {
    CHECK(chi2_p_value(3.841459, 1) == doctest::Approx(0.05).epsilon(1e-5));
    CHECK(chi2_p_value(18.307038, 10) == doctest::Approx(0.05).epsilon(1e-5));
    CHECK(chi2_p_value(2.558212, 10) == doctest::Approx(0.99).epsilon(1e-5));
    CHECK(chi2_p_value(310.45739, 255) == doctest::Approx(0.01).epsilon(1e-4));
    CHECK(sidak(0.01, 1) == doctest::Approx(0.01));
    CHECK(std::pow(1 - sidak(0.01, 20), 20) == doctest::Approx(0.99));
    const auto uniform = [](Vec2 u, Real) { return sample_uniform_hemisphere(u); };
    const auto cosine = [](Vec3 d) { return cosine_hemisphere_pdf(d.z); };
    CHECK(chi2_test_directions(DirectionGrid({0, 0, 1}, 1), kSamples, uniform, cosine).p_value <
          1e-9);
}

TEST_CASE("disk: uniform, and of density 1 / pi") {
    std::vector<double> cells(16 * 32);
    bool inside = true;
    for_numbers([&](Vec2 u, Real) {
        const Vec2 d = sample_uniform_disk(u);
        const double r2 = square(d.x) + square(d.y);
        inside &= r2 <= 1 + 1e-6;
        ++cells[static_cast<size_t>(slot(r2, 16) * 32 + slot(turn_of(d.x, d.y), 32))];
    });
    CHECK(inside);
    CHECK(chi2_test_uniform(cells).p_value > kLevel);
    CHECK(uniform_disk_pdf() * kPi == doctest::Approx(1));
}

TEST_CASE("triangle: uniform") {
    constexpr int kSide = 20;
    std::vector<double> cells(kSide * kSide), expected(kSide * kSide);
    bool inside = true;
    for_numbers([&](Vec2 u, Real) {
        const Vec2 p = sample_uniform_triangle(u);
        inside &= p.x >= 0 && p.y >= 0 && p.x + p.y <= Real(1.000001);
        ++cells[static_cast<size_t>(slot(p.x, kSide) * kSide + slot(p.y, kSide))];
    });
    for (int x = 0; x < kSide; ++x)
        for (int y = 0; x + y < kSide; ++y)
            expected[static_cast<size_t>(x * kSide + y)] =
                kSamples * (x + y == kSide - 1 ? 1.0 : 2.0) / (kSide * kSide);
    CHECK(inside);
    CHECK(uniform_triangle_pdf() == 2);  // over an area of 1/2
    // A point on the hypotenuse may round into the next cell.
    const Chi2 chi2 = chi2_test(cells, expected);
    CHECK(chi2.p_value > kLevel);
    CHECK(chi2.impossible < 5);
}

TEST_CASE("ball: uniform in volume") {
    std::vector<double> cells(8 * 8 * 8);
    for_numbers([&](Vec2 u, Real u3) {
        const Vec3 p = sample_uniform_ball(u, u3);
        const double r = std::sqrt(square(p.x) + square(p.y) + square(p.z));
        const int i = slot(r * r * r, 8), j = slot((p.z / r + 1) / 2, 8),
                  k = slot(turn_of(p.x, p.y), 8);
        ++cells[static_cast<size_t>((i * 8 + j) * 8 + k)];
    });
    CHECK(chi2_test_uniform(cells).p_value > kLevel);
    CHECK(uniform_ball_pdf() * kPi * 4 / 3 == doctest::Approx(1));
}

TEST_CASE("hemisphere by the cosine, hemisphere, sphere") {
    check_directions(
        1, [](Vec2 u, Real) { return sample_cosine_hemisphere(u); },
        [](Vec3 d) { return cosine_hemisphere_pdf(d.z); });
    check_directions(
        1, [](Vec2 u, Real) { return sample_uniform_hemisphere(u); },
        [](Vec3) { return uniform_hemisphere_pdf(); });
    check_directions(
        2, [](Vec2 u, Real) { return sample_uniform_sphere(u); },
        [](Vec3) { return uniform_sphere_pdf(); });
}

TEST_CASE("cone: uniform at any width") {
    for (const double cone : {1.9, 1.0, 0.5, 0.01, 1e-6, 1e-12, 1e-20}) {
        CAPTURE(cone);
        const Real width = static_cast<Real>(cone);
        check_directions(
            cone, [&](Vec2 u, Real) { return sample_uniform_cone(u, width); },
            [&](Vec3) { return uniform_cone_pdf(width); });
    }
}

TEST_CASE("the lobe of fuzzy metal at any radius") {
    const Vec3 axis = normalize(Vec3{Real(0.3), Real(-0.5), Real(0.7)});
    for (const double radius : {0.01, 0.1, 0.5, 0.9, 1.0}) {
        CAPTURE(radius);
        const Real r = static_cast<Real>(radius);
        const double depth = 1 - std::sqrt(1 - radius * radius);
        check_directions(
            depth, [&](Vec2 u, Real u3) { return sample_fuzz_lobe(axis, r, u, u3); },
            [&](Vec3 d) { return fuzz_lobe_pdf(axis, r, d); }, axis);
    }
}

TEST_CASE("the numbers at the rim of the square make unit directions") {
    const Real one = unit_real(0xffffffffu);
    for (const Real x : {Real(0), one}) {
        for (const Real y : {Real(0), one}) {
            for (const Vec3 d :
                 {sample_cosine_hemisphere({x, y}), sample_uniform_hemisphere({x, y}),
                  sample_uniform_sphere({x, y}), sample_uniform_cone({x, y}, Real(0.5)),
                  sample_fuzz_lobe({0, 0, 1}, 1, {x, y}, one)})
                CHECK(length(d) == doctest::Approx(1).epsilon(1e-5));
            CHECK(length(sample_uniform_ball({x, y}, one)) <= Real(1.00001));
        }
    }
}

TEST_CASE("frames are right-handed and orthonormal, and steady where common normals are") {
    const TeaKey key = tea_key(0, 11);
    for (uint32_t i = 0; i < 10000; ++i) {
        const TeaBlock a = tea_encrypt<8>({i, 0}, key);
        const Frame f = frame_around(sample_uniform_sphere({unit_real(a.v0), unit_real(a.v1)}));
        CHECK(length(cross(f.x, f.y) - f.z) < Real(4e-6));
        CHECK(std::abs(length(f.x) - 1) < Real(4e-6));
        CHECK(std::abs(dot(f.x, f.z)) < Real(4e-6));
    }
    // Rounding of a normal turns the frame by no more than itself: else one path would differ
    // between processors.
    const Real tiny = Real(1e-7);
    for (const Vec3 n : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                         Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(Real(0.8), 0, Real(-0.6)),
                         Vec3(Real(0.5), Real(0.70710678), Real(-0.5))}) {
        const Frame here = frame_around(normalize(n + Vec3(0, 0, tiny)));
        const Frame there = frame_around(normalize(n - Vec3(0, 0, tiny)));
        CHECK(length(here.x - there.x) < 20 * tiny);
        CHECK(length(here.y - there.y) < 20 * tiny);
    }
}
