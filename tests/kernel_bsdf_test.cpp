// Bsdfs: sampling against density, weights, energy, reciprocity.
#include "support/chi2.h"

#include <teapath/core/tea.h>
#include <teapath/kernel/bsdf/bsdf.h>

#include <doctest/doctest.h>

#include <initializer_list>

using namespace tp;
using namespace tp::test;

namespace {

Vec2 uniform2(int i, uint32_t stream = 0) {
    const TeaBlock b = tea_encrypt<8>({static_cast<uint32_t>(i), stream}, tea_key(0, 5));
    return {unit_real(b.v0), unit_real(b.v1)};
}

Bsdf make(MaterialKind kind, double fuzz = 0, double eta = 1.5) {
    Bsdf b{};
    b.kind = kind;
    b.fresnel = FresnelRule::Exact;
    b.scatter = ScatterRule::Cosine;
    b.color = Vec3(Real(0.8));
    b.normal = normalize(Vec3(Double3(0.1, 0.2, 1)));
    b.fuzz = static_cast<Real>(fuzz);
    b.eta = static_cast<Real>(eta);
    return b;
}

// A unit vector at `degrees` from the bsdf's normal.
Vec3 at_angle(const Bsdf& b, double degrees) {
    const double a = degrees * 3.14159265358979323846 / 180;
    return frame_around(b.normal).to_world(
        Vec3(Double3(std::sin(a) * 0.6, std::sin(a) * 0.8, std::cos(a))));
}

const std::initializer_list<double> kAngles = {0.0, 30.0, 60.0, 85.0};

}  // namespace

TEST_CASE("sampling follows the density, and absorbs what the density lacks") {
    int tests = 0;
    for (const Bsdf& b : {make(MaterialKind::Lambertian), make(MaterialKind::Metal, 0.1),
                          make(MaterialKind::Metal, 0.5), make(MaterialKind::Metal, 1)}) {
        for (const double angle : kAngles) {
            const Vec3 wo = at_angle(b, angle);
            SphereBins bins;
            if (b.fuzz > 0 && b.fuzz < Real(0.2)) bins = {80, 160};
            const double p = chi2_directions<Vec3>(
                [&](int i) {
                    return is_black(bsdf_sample(b, wo, uniform2(i), uniform2(i, 1).x).weight)
                               ? Vec3(0)
                               : bsdf_sample(b, wo, uniform2(i), uniform2(i, 1).x).wi;
                },
                [&](const Vec3& wi) { return static_cast<double>(bsdf_pdf(b, wo, wi)); }, 200000,
                bins);
            CAPTURE(static_cast<int>(b.kind));
            CAPTURE(b.fuzz);
            CAPTURE(angle);
            CHECK(p > sidak(16));
            ++tests;
        }
    }
    CHECK(tests == 16);
}

TEST_CASE("a sample's weight is value over density") {
    for (const Bsdf& b : {make(MaterialKind::Lambertian), make(MaterialKind::Metal, 0.4)}) {
        const Vec3 wo = at_angle(b, 50);
        for (int i = 0; i < 1000; ++i) {
            const BsdfSample s = bsdf_sample(b, wo, uniform2(i), uniform2(i, 1).x);
            if (is_black(s.weight)) continue;
            CHECK(length(s.wi) == doctest::Approx(1).epsilon(1e-5));
            CHECK(s.pdf == doctest::Approx(bsdf_pdf(b, wo, s.wi)).epsilon(0.01));
            CHECK(s.weight.x * s.pdf == doctest::Approx(bsdf_eval(b, wo, s.wi).x).epsilon(0.01));
        }
    }
}

TEST_CASE("no more comes out than goes in") {
    for (const Bsdf& b : {make(MaterialKind::Lambertian), make(MaterialKind::Metal, 0),
                          make(MaterialKind::Metal, 0.5), make(MaterialKind::Metal, 1),
                          make(MaterialKind::Dielectric)}) {
        for (const double angle : kAngles) {
            const Vec3 wo = at_angle(b, angle);
            double reflected = 0;
            constexpr int n = 100000;
            for (int i = 0; i < n; ++i) {
                const BsdfSample s = bsdf_sample(b, wo, uniform2(i), uniform2(i, 1).x);
                // Basic radiance: refraction packs rays, which is no energy.
                reflected += static_cast<double>(s.weight.x * s.eta_scale) / n;
            }
            CAPTURE(angle);
            CHECK(reflected <= 0.8001);
            if (b.kind != MaterialKind::Metal || b.fuzz == 0)
                CHECK(reflected == doctest::Approx(0.8).epsilon(0.001));
        }
    }
}

TEST_CASE("reciprocity of the Lambertian, and of glass up to the square of the index") {
    const Bsdf b = make(MaterialKind::Lambertian);
    for (int i = 0; i < 200; ++i) {
        const Vec3 wo = frame_around(b.normal).to_world(sample_cosine_hemisphere(uniform2(i))),
                   wi = frame_around(b.normal).to_world(sample_cosine_hemisphere(uniform2(i, 3)));
        const Real forth = bsdf_eval(b, wo, wi).x / dot(b.normal, wi),
                   back = bsdf_eval(b, wi, wo).x / dot(b.normal, wo);
        CHECK(forth == doctest::Approx(back).epsilon(1e-4));
    }
    // Transmittance is the same from both sides along the same path.
    for (const double angle : {0.0, 20.0, 40.0, 70.0}) {
        const auto cos_i = static_cast<Real>(std::cos(angle * 3.14159265 / 180));
        const Real eta = Real(1.5), sin2_t = (1 - cos_i * cos_i) / (eta * eta),
                   cos_t = tp::sqrt(1 - sin2_t);
        CHECK(fresnel_dielectric(cos_i, eta) ==
              doctest::Approx(fresnel_dielectric(cos_t, 1 / eta)).epsilon(1e-4));
    }
}

TEST_CASE("delta lobes are invisible to evaluation, and light is none of its business") {
    const Bsdf mirror = make(MaterialKind::Metal, 0), glass = make(MaterialKind::Dielectric),
               light = make(MaterialKind::DiffuseLight);
    CHECK(is_specular(mirror));
    CHECK(is_specular(glass));
    CHECK_FALSE(is_specular(make(MaterialKind::Metal, 0.2)));
    for (const Bsdf& b : {mirror, glass, light}) {
        CHECK(is_black(bsdf_eval(b, at_angle(b, 30), at_angle(b, 30))));
        CHECK(bsdf_pdf(b, at_angle(b, 30), at_angle(b, 30)) == 0);
    }
    CHECK(is_black(bsdf_sample(light, at_angle(light, 10), {Real(0.5), Real(0.5)}, 0).weight));
}
