// The principled surface: samples follow the density, no lobe and no mix loses or makes energy,
// light may be followed backwards where the model says so, and without compensation it is glTF's
// appendix B.
#include "support/chi2.h"

#include <teapath/device/albedo_arrays.h>
#include <teapath/kernel/bsdf/principled.h>

#include <doctest/doctest.h>

#include <functional>
#include <string>
#include <vector>

using namespace tp;
using namespace tp::test;

namespace {

constexpr uint32_t kSamples = 200000;

AlbedoTables tables() {
    return albedo_arrays().view();
}

Vec3 tilted(double degrees, double turn = 0.3) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    return normalize(Vec3(Double3(std::sin(angle) * std::cos(turn),
                                  std::sin(angle) * std::sin(turn), std::cos(angle))));
}

struct Case {
    std::string name;
    PrincipledParameters p;
};

// White surfaces of every lobe, and mixes.
std::vector<Case> white_cases() {
    PrincipledParameters white;
    white.base = {1, 1, 1};
    std::vector<Case> cases;
    const auto add = [&](const char* name, double roughness,
                         const std::function<void(PrincipledParameters&)>& change) {
        PrincipledParameters p = white;
        const auto alpha = static_cast<Real>(std::max(roughness * roughness, 1e-3));
        p.alpha = {alpha, alpha};
        change(p);
        cases.push_back({std::string(name) + ", roughness " + std::to_string(roughness), p});
    };
    for (const double roughness : {0.1, 0.3, 0.6, 1.0}) {
        add("diffuse under a dielectric", roughness, [](auto&) {});
        add("metal", roughness, [](auto& p) { p.metallic = 1; });
        add("half a metal", roughness, [](auto& p) { p.metallic = Real(0.5); });
        add("thin glass", roughness, [](auto& p) { p.transmission = 1; });
        add("glass", roughness, [](auto& p) { p.transmission = 1, p.thin = false; });
        add("glass from within", roughness, [](auto& p) {
            p.transmission = 1, p.thin = false;
            p.eta = 1 / Real(1.5);
        });
        add("half a glass", roughness, [](auto& p) { p.transmission = Real(0.5), p.thin = false; });
        add("leaf", roughness, [](auto& p) { p.diffuse_transmission = Real(0.6); });
        add("coat on metal", roughness, [](auto& p) { p.metallic = 1, p.coat = 1; });
        add("rough coat on diffuse", roughness,
            [](auto& p) { p.coat = Real(0.8), p.coat_alpha = Real(0.3); });
        add("a coat of its own normal", roughness, [](auto& p) {
            p.coat = Real(0.8), p.coat_alpha = Real(0.3);
            p.coat_normal = normalize(Vec3(Real(0.15), Real(-0.1), 1));
        });
        add("film on metal", roughness, [](auto& p) { p.metallic = 1, p.film = 1; });
        add("sheen", roughness, [](auto& p) { p.sheen = Vec3(1), p.sheen_alpha = Real(0.25); });
        add("all layers", roughness, [](auto& p) {
            p.sheen = Vec3(Real(0.5)), p.coat = Real(0.5), p.metallic = Real(0.3);
            p.transmission = Real(0.3), p.diffuse_transmission = Real(0.4);
        });
    }
    return cases;
}

// The mean weight of samples; refraction's squared index, which counts beams not radiance, apart.
double albedo(const PrincipledParameters& p, double degrees, uint32_t samples) {
    const Vec3 wo = tilted(degrees);
    const PrincipledLobes l = make_principled(p, tables(), wo);
    const TeaKey key = tea_key(0, 5);
    double sum = 0;
    for (uint32_t i = 0; i < samples; ++i) {
        const TeaBlock a = tea_encrypt<8>({i, 0}, key), c = tea_encrypt<8>({i, 1}, key);
        const BsdfSample s =
            principled_sample(l, tables(), wo, {unit_real(a.v0), unit_real(a.v1)}, unit_real(c.v0));
        sum += static_cast<double>(s.weight.y * s.eta_scale);
    }
    return sum / samples;
}

int samples_without_density(const PrincipledLobes& l, Vec3 wo) {
    const TeaKey key = tea_key(0, 6);
    int count = 0;
    for (uint32_t i = 0; i < 20000; ++i) {
        const TeaBlock a = tea_encrypt<8>({i, 0}, key), c = tea_encrypt<8>({i, 1}, key);
        Vec3 wi{0, 0, 0};
        if (principled_direction(l, wo, {unit_real(a.v0), unit_real(a.v1)}, unit_real(c.v0), wi))
            count += !(principled_pdf(l, wo, wi) > 0);
    }
    return count;
}

}  // namespace

TEST_CASE("principled: a white furnace stays white, whatever the lobes and the roughness") {
    for (const Case& c : white_cases()) {
        CAPTURE(c.name);
        // Films take colours away, and a coat that is turned loses what it reflects below.
        if (c.p.film > 0 || c.p.coat_normal.z < 1) continue;
        for (const double degrees : {0.0, 35.0, 60.0, 80.0}) {
            CAPTURE(degrees);
            CHECK(albedo(c.p, degrees, 40000) == doctest::Approx(1).epsilon(0.01));
        }
    }
}

TEST_CASE("principled: films and turned coats make no light") {
    for (const Case& c : white_cases()) {
        if (!(c.p.film > 0 || c.p.coat_normal.z < 1)) continue;
        CAPTURE(c.name);
        for (const double degrees : {0.0, 35.0, 60.0, 80.0}) {
            CAPTURE(degrees);
            CHECK(albedo(c.p, degrees, 20000) < 1.02);
            CHECK(albedo(c.p, degrees, 20000) > 0.3);
        }
    }
}

TEST_CASE("thin film: without thickness or index it is not there, else it has colours") {
    const Vec3 base{Real(0.04), Real(0.5), Real(0.9)};
    const Vec3 none = film_reflectance(1, Real(1.3), 0, base);
    for (int i = 0; i < 3; ++i)
        CHECK(none[i] == doctest::Approx(static_cast<double>(base[i])).epsilon(1e-3));
    for (const double cosine : {1.0, 0.6, 0.2}) {
        const auto c = static_cast<Real>(cosine);
        const Vec3 seen(schlick(Real(0.3), c));
        CHECK(straight_on(seen, c).y == doctest::Approx(0.3).epsilon(0.001));
        for (const double thickness : {100.0, 250.0, 400.0, 800.0, 3000.0}) {
            const Vec3 f = film_reflectance(c, Real(1.4), static_cast<Real>(thickness), base);
            for (int i = 0; i < 3; ++i)
                CHECK((f[i] >= 0 && f[i] <= 1));
        }
    }
    // A quarter of a wave of green light on glass: the coating of lenses takes green away.
    const Vec3 glass(Real(0.04));
    const Vec3 coated = film_reflectance(1, Real(1.22), Real(550 / 4.0 / 1.22), glass);
    CHECK(coated.y < Real(0.01));
    CHECK(coated.y < coated.z);
}

TEST_CASE("principled: without compensation nothing is made, and rough metal loses") {
    for (Case c : white_cases()) {
        c.p.compensation = false;
        CAPTURE(c.name);
        CHECK(albedo(c.p, 50, 20000) < 1.02);
    }
    PrincipledParameters metal;
    metal.base = {1, 1, 1};
    metal.metallic = 1;
    metal.alpha = {1, 1};
    metal.compensation = false;
    CHECK(albedo(metal, 30, 20000) < 0.8);
}

TEST_CASE("principled: samples follow the density") {
    const std::vector<Case> cases = white_cases();
    const double level = sidak(0.01, static_cast<int>(cases.size()) * 2);
    for (const Case& c : cases) {
        if (c.p.alpha.x < Real(0.05)) continue;  // lobes finer than the test's cells
        CAPTURE(c.name);
        for (const double degrees : {20.0, 70.0}) {
            PrincipledParameters p = c.p;
            p.alpha.x = min(p.alpha.x * 2, Real(1));  // a lobe that is longer one way
            p.coat_alpha = max(p.coat_alpha, Real(0.1));
            const Vec3 wo = tilted(degrees);
            const PrincipledLobes l = make_principled(p, tables(), wo);
            for (const Vec3 axis : {Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
                const Chi2 chi2 = chi2_test_directions(
                    DirectionGrid{axis, 1}, kSamples,
                    [&](Vec2 u, Real choice) {
                        Vec3 wi{0, 0, 0};
                        return principled_direction(l, wo, u, choice, wi) ? wi : Vec3(0, 0, 0);
                    },
                    [&](Vec3 wi) { return principled_pdf(l, wo, wi); });
                CHECK(chi2.p_value > level);
            }
            CHECK(samples_without_density(l, wo) == 0);
        }
    }
}

TEST_CASE("principled: light may be followed backwards but for coat, film and sheen") {
    for (const Case& c : white_cases()) {
        if (c.p.coat > 0 || c.p.film > 0 || !is_black(c.p.sheen)) continue;
        if (c.p.transmission > 0 && c.p.compensation) continue;  // scaled by wo's loss alone
        CAPTURE(c.name);
        const Vec3 a = tilted(30, 0.2), b = tilted(65, 2);
        const Vec3 ab = principled_eval(make_principled(c.p, tables(), a), tables(), a, b) / b.z;
        const Vec3 ba = principled_eval(make_principled(c.p, tables(), b), tables(), b, a) / a.z;
        CHECK(ab.x == doctest::Approx(static_cast<double>(ba.x)).epsilon(1e-3));
    }
}

TEST_CASE("principled: without compensation it is glTF's appendix B") {
    PrincipledParameters p;
    p.base = {Real(0.9), Real(0.5), Real(0.2)};
    p.compensation = false;
    for (const double metallic : {0.0, 0.4, 1.0})
        for (const double roughness : {0.2, 0.5, 1.0}) {
            p.metallic = static_cast<Real>(metallic);
            const double alpha = roughness * roughness;
            p.alpha = {static_cast<Real>(alpha), static_cast<Real>(alpha)};
            const Vec3 wo = tilted(40), wi = tilted(55, 1.4);
            const Vec3 f = principled_eval(make_principled(p, tables(), wo), tables(), wo, wi);
            // The formulas of the appendix, in double.
            const Double3 o = wo, i = wi, h = glm::normalize(o + i), base = p.base;
            const double a2 = alpha * alpha, pi = 3.14159265358979323846;
            const double d = a2 / (pi * std::pow(h.z * h.z * (a2 - 1) + 1, 2));
            const double v = 0.5 / (i.z * std::sqrt(o.z * o.z * (1 - a2) + a2) +
                                    o.z * std::sqrt(i.z * i.z * (1 - a2) + a2));
            const Double3 f0 = glm::mix(Double3(0.04), base, metallic);
            const Double3 fresnel = f0 + (1.0 - f0) * std::pow(1 - glm::dot(o, h), 5);
            const Double3 wanted =
                ((1.0 - fresnel) * (base * (1 - metallic)) / pi + fresnel * d * v) * i.z;
            for (int channel = 0; channel < 3; ++channel)
                CHECK(static_cast<double>(f[channel]) ==
                      doctest::Approx(wanted[channel]).epsilon(1e-4));
        }
}

TEST_CASE("sheen: a cosine that rounding has left above 1 is no trouble") {
    for (const Real alpha : {kLeastSheenAlpha, Real(0.1), Real(0.5), Real(1)}) {
        const Real above = 1 + 2 * kEpsilon;
        CHECK(sheen_lambda(above, alpha) == doctest::Approx(sheen_lambda(1, alpha)).epsilon(0.01));
        CHECK(std::isfinite(sheen_reflection(alpha, {0, 0, above}, {0, 0, above})));
    }
}
