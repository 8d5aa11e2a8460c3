// AC-P1: the tone curves against the figures of their sources, and 8 bits exact to one code.
#include <teapath/core/enum_table.h>
#include <teapath/kernel/post.h>
#include <teapath/scene/enum_tables.h>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace tp;

namespace {

Vec3 grey(double x) {
    return Vec3(static_cast<Real>(x));
}

double of_grey(Vec3 (*curve)(Vec3), double x) {
    return static_cast<double>(curve(grey(x)).x);
}

void check_color(Vec3 c, double r, double g, double b) {
    CHECK(static_cast<double>(c.x) == doctest::Approx(r).epsilon(2e-5));
    CHECK(static_cast<double>(c.y) == doctest::Approx(g).epsilon(2e-5));
    CHECK(static_cast<double>(c.z) == doctest::Approx(b).epsilon(2e-4));
}

}  // namespace

TEST_CASE("AC-P1: Khronos PBR Neutral") {
    CHECK(of_grey(neutral_curve, 0.18) == doctest::Approx(0.14).epsilon(1e-5));
    CHECK(of_grey(neutral_curve, 1) == doctest::Approx(0.86909).epsilon(2e-5));
    CHECK(of_grey(neutral_curve, 4) == doctest::Approx(0.98326).epsilon(2e-5));
    check_color(neutral_curve({10, 0, 0}), 0.99392, 0.57114, 0.57114);
    check_color(neutral_curve({1, Real(0.5), Real(0.1)}), 0.86909, 0.42253, 0.06528);
    for (double x = 0.08; x < 0.8; x += 0.01)
        CHECK(of_grey(neutral_curve, x) == doctest::Approx(x - 0.04).epsilon(1e-5));
}

TEST_CASE("AC-P1: the ACES fit and AgX") {
    for (const auto& row :
         {std::array{0.18, 0.26690, 0.2145}, {1.0, 0.80380, 0.5901}, {4.0, 0.97342, 0.8609}}) {
        const double x = row[0], aces = row[1], agx = row[2];
        CAPTURE(x);
        CHECK(static_cast<double>(aces_curve(static_cast<float>(x))) ==
              doctest::Approx(aces).epsilon(1e-4));
        CHECK(std::abs(of_grey(agx_curve, x) - agx) < 5e-4);
    }
}

TEST_CASE("every tone curve rises, starts at black and meets odd radiance with a colour") {
    for (const auto& row : EnumTable<ToneCurve>::rows) {
        CAPTURE(row.name);
        Real last = -1;
        for (double stops = -14; stops < 12; stops += 0.01) {
            const Real now = tone_map(grey(std::exp2(stops)), row.value).y;
            CHECK(now >= last - Real(2e-6));
            last = now;
        }
        CHECK(last > Real(0.95));
        CHECK(tone_map(grey(0), row.value).x <= Real(0.01));
        const Real infinity = std::numeric_limits<Real>::infinity();
        const Real nan = std::numeric_limits<Real>::quiet_NaN();
        for (const Vec3 odd :
             {grey(1e30), Vec3(nan, 0, 1), Vec3(infinity, 0, 0), Vec3(-1, -2, 3)}) {
            const Vec3 c = tone_map(odd, row.value);
            for (int i = 0; i < 3; ++i)
                CHECK((c[i] >= 0 && c[i] <= 1));
        }
    }
}

TEST_CASE("8-bit sRGB codes are the nearest ones, and exposure is in stops") {
    DisplaySettings display;
    for (int code = 0; code < 256; ++code) {
        const Rgb8 c =
            display_color(grey(linear_from_srgb(static_cast<float>(code) / 255)), display);
        CHECK(c.r == code);
    }
    display.exposure = 2;
    DisplaySettings plain;
    CHECK(display_color(grey(0.1), display).g == display_color(grey(0.4), plain).g);
}
