// The contract of a bsdf, for every kind of material: samples follow the density, weights are
// eval / pdf, no energy is made, light may be followed backwards.
#include "support/chi2.h"

#include <teapath/kernel/bsdf/bsdf.h>

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace tp;
using namespace tp::test;

namespace {

constexpr uint32_t kSamples = 200000;
const double kLevel = sidak(0.01, 24);  // of each chi-squared test in this file

Bsdf make(MaterialKind kind, Real fuzz = 0, Vec3 color = Vec3(1)) {
    Bsdf b;
    b.kind = kind;
    b.fresnel = FresnelRule::Exact;
    b.scatter = ScatterRule::Cosine;
    b.color = color;
    b.normal = normalize(Vec3{Real(-0.2), Real(0.9), Real(0.4)});
    b.fuzz = fuzz;
    b.eta = Real(1.5);
    return b;
}

// A unit vector at `degrees` to the normal.
Vec3 tilted(const Bsdf& b, double degrees, double turn = 0.3) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    return normalize(frame_around(b.normal).to_world(
        {static_cast<Real>(std::sin(angle) * std::cos(turn)),
         static_cast<Real>(std::sin(angle) * std::sin(turn)), static_cast<Real>(std::cos(angle))}));
}

// Calls f(sample) for `count` samples of the bsdf.
template <class F>
void for_samples(const Bsdf& b, Vec3 wo, uint32_t count, F&& f) {
    const TeaKey key = tea_key(0, 3);
    for (uint32_t i = 0; i < count; ++i) {
        const TeaBlock a = tea_encrypt<8>({i, 0}, key), c = tea_encrypt<8>({i, 1}, key);
        f(bsdf_sample(b, wo, {unit_real(a.v0), unit_real(a.v1)}, unit_real(c.v0)));
    }
}

constexpr double kAngles[] = {0, 30, 60, 85};
constexpr double kFuzz[] = {0.1, 0.5, 1};

// The cap of directions that a bsdf scatters into.
DirectionGrid grid_of(const Bsdf& b, Vec3 wo) {
    if (b.kind != MaterialKind::Metal) return {b.normal, 1};
    const double fuzz = static_cast<double>(b.fuzz);
    return {reflect(wo, b.normal), 1 - std::sqrt(1 - fuzz * fuzz)};
}

// Calls f(bsdf, wo) for all that have a density.
template <class F>
void for_smooth_bsdfs(F&& f) {
    for (const double angle : kAngles) {
        CAPTURE(angle);
        Bsdf matte = make(MaterialKind::Lambertian);
        f(matte, tilted(matte, angle));
        for (const double fuzz : kFuzz) {
            CAPTURE(fuzz);
            const Bsdf metal = make(MaterialKind::Metal, static_cast<Real>(fuzz));
            f(metal, tilted(metal, angle));
        }
    }
}

struct Moments {
    double cosine = 0, square = 0;
};
Moments cosine_moments(ScatterRule rule) {
    Bsdf b = make(MaterialKind::Lambertian);
    b.scatter = rule;
    Moments m;
    constexpr uint32_t kCount = 1u << 22;
    for_samples(b, b.normal, kCount, [&](const BsdfSample& s) {
        const double cosine = static_cast<double>(dot(s.wi, b.normal));
        m.cosine += cosine / kCount;
        m.square += cosine * cosine / kCount;
    });
    return m;
}

}  // namespace

TEST_CASE("AC-F3: Lambert's mean cosine is 2/3; the other rules are told apart") {
    const Moments lambert = cosine_moments(ScatterRule::Cosine);
    CHECK(std::abs(lambert.cosine - 2.0 / 3) < 0.0005);
    CHECK(std::abs(lambert.square - 0.5) < 0.0005);
    CHECK(std::abs(cosine_moments(ScatterRule::CosineCubed).cosine - 0.8) < 0.0005);
    CHECK(std::abs(cosine_moments(ScatterRule::Hemisphere).cosine - 0.5) < 0.0005);
}

TEST_CASE("samples follow the density, absorbed ones are what it lacks to 1") {
    for_smooth_bsdfs([](const Bsdf& b, Vec3 wo) {
        double lost[2];
        CHECK_FALSE(is_specular(b));
        const Chi2 chi2 = chi2_test_directions(
            grid_of(b, wo), kSamples, [&](Vec2 u, Real u3) { return bsdf_sample(b, wo, u, u3).wi; },
            [&](Vec3 wi) { return bsdf_pdf(b, wo, wi); }, &lost);
        CAPTURE(chi2.statistic);
        CAPTURE(chi2.degrees);
        CHECK(chi2.p_value > kLevel);
        CHECK(chi2.impossible < 10);
        CHECK(lost[0] == doctest::Approx(lost[1]).epsilon(0.005).scale(1));
        if (b.kind == MaterialKind::Lambertian) CHECK(lost[0] < 1e-4);
    });
}

TEST_CASE("the other scatter rules follow their densities") {
    Bsdf b = make(MaterialKind::Lambertian);
    const auto p_value = [&](ScatterRule rule, auto&& pdf) {
        b.scatter = rule;
        return chi2_test_directions(
                   DirectionGrid(b.normal, 1), kSamples,
                   [&](Vec2 u, Real u3) { return bsdf_sample(b, b.normal, u, u3).wi; }, pdf)
            .p_value;
    };
    CHECK(p_value(ScatterRule::Hemisphere, [](Vec3) { return uniform_hemisphere_pdf(); }) > kLevel);
    CHECK(p_value(ScatterRule::CosineCubed, [&](Vec3 wi) {
              const Real c = max(dot(wi, b.normal), Real(0));
              return 2 * c * c * c * kInvPi;
          }) > kLevel);
}

TEST_CASE("a sample's density is bsdf_pdf, its weight bsdf_eval over it") {
    for_smooth_bsdfs([](Bsdf b, Vec3 wo) {
        b.color = {Real(0.8), Real(0.5), Real(0.2)};
        int wrong_pdf = 0, wrong_weight = 0, below = 0;
        for_samples(b, wo, 20000, [&](const BsdfSample& s) {
            if (is_black(s.weight)) return;
            const Real pdf = bsdf_pdf(b, wo, s.wi);
            wrong_pdf += tp::abs(pdf - s.pdf) > Real(1e-5) * max(pdf, Real(1));
            const Vec3 difference = bsdf_eval(b, wo, s.wi) - s.weight * pdf;
            wrong_weight += max_component(abs(difference)) > Real(1e-5) * max(pdf, Real(1));
            below += dot(s.wi, b.normal) < 0;
        });
        CHECK(wrong_pdf == 0);
        CHECK(wrong_weight == 0);
        CHECK(below <= 1);  // rounding at the horizon
        // Nothing below the surface.
        CHECK(is_black(bsdf_eval(b, wo, -b.normal)));
        CHECK(bsdf_pdf(b, wo, -b.normal) == 0);
    });
}

TEST_CASE("energy: no more goes out than comes in, by quadrature and by samples alike") {
    for_smooth_bsdfs([](const Bsdf& b, Vec3 wo) {
        double sampled = 0, integrated = 0;
        for_samples(b, wo, kSamples, [&](const BsdfSample& s) {
            sampled += static_cast<double>(s.weight.x) / kSamples;
        });
        for (const double cell :
             grid_of(b, wo).integrate([&](Vec3 wi) { return bsdf_eval(b, wo, wi).x; }))
            integrated += cell;
        CHECK(sampled <= 1 + 1e-6);
        CHECK(integrated <= 1 + 1e-3);
        CHECK(sampled == doctest::Approx(integrated).epsilon(0.006));
    });
}

TEST_CASE("reciprocity: Lambertian") {
    const Bsdf b = make(MaterialKind::Lambertian, 0, Vec3(Real(0.7)));
    for (const double i : {0.0, 20.0, 50.0, 80.0}) {
        for (const double o : {10.0, 45.0, 89.0}) {
            const Vec3 wi = tilted(b, i), wo = tilted(b, o, 2);
            CHECK(bsdf_eval(b, wo, wi).x / dot(wi, b.normal) ==
                  doctest::Approx(bsdf_eval(b, wi, wo).x / dot(wo, b.normal)).epsilon(1e-4));
        }
    }
}

TEST_CASE("a mirror reflects back to where the light came from") {
    const Bsdf b = make(MaterialKind::Metal, 0, Vec3(Real(0.7)));
    CHECK(is_specular(b));
    for (const double angle : kAngles) {
        const Vec3 wo = tilted(b, angle);
        const BsdfSample there = bsdf_sample(b, wo, {Real(0.3), Real(0.6)}, 0);
        const BsdfSample back = bsdf_sample(b, there.wi, {Real(0.3), Real(0.6)}, 0);
        CHECK(length(back.wi - wo) < Real(1e-5));
        CHECK(dot(there.wi, b.normal) == doctest::Approx(dot(wo, b.normal)).epsilon(1e-4));
        CHECK(there.weight == b.color);
        CHECK(back.weight == b.color);
        CHECK(there.pdf == 0);
        CHECK(bsdf_pdf(b, wo, there.wi) == 0);
        CHECK(is_black(bsdf_eval(b, wo, there.wi)));
    }
}

TEST_CASE("glass: shares sum to 1, refraction is reversible up to the square of the index") {
    for (const double index : {1.5, 1 / 1.5, 2.4}) {
        for (const double angle : {0.0, 15.0, 40.0, 41.5, 43.0, 70.0, 89.0}) {
            CAPTURE(index);
            CAPTURE(angle);
            Bsdf b = make(MaterialKind::Dielectric, 0, Vec3(Real(0.9)));
            b.eta = static_cast<Real>(index);
            CHECK(is_specular(b));
            const Vec3 wo = tilted(b, angle);
            const Real reflectance = fresnel_dielectric(min(dot(wo, b.normal), Real(1)), b.eta);

            // Which lobe, and how often.
            double reflected = 0, energy = 0;
            bool sides = true;
            for_samples(b, wo, kSamples, [&](const BsdfSample& s) {
                const bool up = dot(s.wi, b.normal) > 0;
                sides &= up == (s.eta_scale == 1);
                reflected += up ? 1.0 / kSamples : 0;
                energy += static_cast<double>(s.weight.x * s.eta_scale) / kSamples;
            });
            CHECK(sides);
            CHECK(reflected ==
                  doctest::Approx(static_cast<double>(reflectance)).epsilon(0.005).scale(1));
            CHECK(energy == doctest::Approx(0.9).epsilon(1e-4));  // the tint, and nothing else
            if (reflectance >= 1) continue;

            // The same way back through the other side.
            const BsdfSample there = bsdf_sample(b, wo, {Real(0.9999), 0}, 0);
            Bsdf other = b;
            other.normal = -b.normal;
            other.eta = 1 / b.eta;
            const Real reflectance_back =
                fresnel_dielectric(min(dot(there.wi, other.normal), Real(1)), other.eta);
            const BsdfSample back = bsdf_sample(other, there.wi, {Real(0.9999), 0}, 0);
            CHECK(length(back.wi - wo) < Real(2e-3));
            CHECK(reflectance_back ==
                  doctest::Approx(static_cast<double>(reflectance)).epsilon(2e-3));
            CHECK(there.weight.x * b.eta * b.eta ==
                  doctest::Approx(static_cast<double>(back.weight.x / (b.eta * b.eta))));
            CHECK(there.eta_scale * back.eta_scale == doctest::Approx(1));
        }
    }
}

TEST_CASE("glass by Schlick's rule makes no energy either") {
    for (const double angle : kAngles) {
        Bsdf b = make(MaterialKind::Dielectric);
        b.fresnel = FresnelRule::Schlick;
        for (const Real eta : {Real(1.5), 1 / Real(1.5)}) {
            b.eta = eta;
            for_samples(b, tilted(b, angle), 100, [](const BsdfSample& s) {
                CHECK(s.weight.x * s.eta_scale == doctest::Approx(1));
            });
        }
    }
}

TEST_CASE("a light scatters nothing") {
    const Bsdf b = make(MaterialKind::DiffuseLight);
    const Vec3 wo = tilted(b, 30);
    for_samples(b, wo, 100, [](const BsdfSample& s) { CHECK(is_black(s.weight)); });
    CHECK(is_black(bsdf_eval(b, wo, b.normal)));
    CHECK(bsdf_pdf(b, wo, b.normal) == 0);
}
