// Light sampling by chi squared: the point on every kind of shape.
#include "support/chi2.h"
#include "support/hittables.h"

#include <teapath/kernel/light.h>

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace tp;
using namespace tp::test;

namespace {

const double kLevel = sidak(0.01, 40);  // of each test in this file

// Density over solid angle of light sampling from `from` in direction `d`.
Real density(const Hittable& h, Vec3 from, Vec3 d) {
    Hit hit;
    if (!intersect(h, from, d, kInfinity, hit)) return 0;
    return pdf_toward(h, from, d, surface_at(h, from, d, hit), hit.t);
}

// The rim of a shape is an edge of its density, which needs many steps to integrate.
void check_shape(const Hittable& h, Vec3 from, const DirectionGrid& grid, int steps) {
    CAPTURE(static_cast<int>(h.kind));
    CAPTURE(from.x);
    double lost[2];
    const Chi2 chi2 = chi2_test_directions(
        grid, 100000,
        [&](Vec2 u, Real) {
            const ShapeSample s = sample_toward(h, from, u);
            return s.pdf > 0 ? s.direction : Vec3(0, 0, 0);
        },
        [&](Vec3 d) { return density(h, from, d); }, &lost, steps);
    CAPTURE(chi2.statistic);
    CAPTURE(chi2.degrees);
    CAPTURE(chi2.impossible);
    CHECK(chi2.p_value > kLevel);
    CHECK(chi2.degrees > 30);
    CHECK(chi2.impossible < 20);  // at the very rim
    CHECK(lost[0] == doctest::Approx(lost[1]).epsilon(0.01).scale(1));
    CHECK(lost[0] < 0.001);
}

}  // namespace

TEST_CASE("light sampling: chi squared of every kind of shape, from outside") {
    for (const Hittable& h : one_of_each()) {
        for (const Vec3& from : {Vec3(3, 2, 4), Vec3(-1, Real(2.5), Real(0.5))}) {
            // The cap around the shape.
            const Bounds b = bounds_of(h);
            const Vec3 middle = (b.low + b.high) * Real(0.5);
            const double reach = double(length(b.extent())) / 2 / double(length(from - middle));
            const double depth = reach < 1 ? 1 - std::sqrt(1 - reach * reach) : 1;
            check_shape(h, from, DirectionGrid(normalize(middle - from), depth), 64);
        }
    }
}

TEST_CASE("light sampling: chi squared of closed shapes, from within") {
    for (const Hittable& h :
         {sphere({0, 0, 0}, 1), ellipsoid({0, 0, 0}, kAxes), box({0, 0, 0}, kAxes)})
        for (const Vec3& from : {Vec3(0, 0, 0), Vec3(Real(0.2), Real(-0.1), Real(0.3))})
            check_shape(h, from, DirectionGrid({0, 0, 1}, 2), 24);
}
