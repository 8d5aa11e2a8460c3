// Conductors and rough dielectrics: reflectance by closed forms, samples that follow the density,
// energy, reciprocity.
#include "support/chi2.h"

#include <teapath/device/albedo_arrays.h>
#include <teapath/kernel/bsdf/bsdf.h>
#include <teapath/scene/enum_tables.h>
#include <teapath/scene/material.h>

#include <doctest/doctest.h>

#include <cmath>

using namespace tp;
using namespace tp::test;

namespace {

constexpr uint32_t kSamples = 200000;

Vec3 tilted(double degrees, double turn = 0.3) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    return normalize(Vec3(Double3(std::sin(angle) * std::cos(turn),
                                  std::sin(angle) * std::sin(turn), std::cos(angle))));
}

// White facets in the frame of z: metals of reflectance 1, glass of that index.
Bsdf facets(MaterialKind kind, double alpha, double eta = 1.5, bool correlated = true) {
    Bsdf b;
    b.kind = kind;
    b.fresnel = FresnelRule::Exact;
    b.scatter = ScatterRule::Cosine;
    b.color = {1, 1, 1};
    b.normal = {0, 0, 1};
    b.fuzz = 0;
    b.eta = static_cast<Real>(eta);
    b.is_rough = alpha > 0;
    b.facets.frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    b.facets.alpha = static_cast<Real>(alpha);
    b.facets.correlated = correlated;
    b.facets.gain = {1, 1, 1};
    b.facets.eta = Vec3(Real(0.01));
    b.facets.k = Vec3(Real(100));
    return b;
}

template <class F>
void for_rough(F&& f) {
    for (const double alpha : {0.1, 0.3, 0.7})
        for (const bool correlated : {true, false})
            for (const double degrees : {10.0, 50.0, 80.0}) {
                CAPTURE(alpha);
                CAPTURE(correlated);
                CAPTURE(degrees);
                f(facets(MaterialKind::Conductor, alpha, 1.5, correlated), tilted(degrees));
                for (const double eta : {1.5, 1 / 1.5}) {
                    CAPTURE(eta);
                    f(facets(MaterialKind::Dielectric, alpha, eta, correlated), tilted(degrees));
                }
            }
}

template <class F>
void for_samples(const Bsdf& b, Vec3 wo, uint32_t count, F&& f) {
    const TeaKey key = tea_key(0, 3);
    for (uint32_t i = 0; i < count; ++i) {
        const TeaBlock a = tea_encrypt<8>({i, 0}, key), c = tea_encrypt<8>({i, 1}, key);
        f(bsdf_sample(b, wo, {unit_real(a.v0), unit_real(a.v1)}, unit_real(c.v0)));
    }
}

double albedo(const Bsdf& b, Vec3 wo) {
    double sum = 0;
    for_samples(b, wo, 40000, [&](const BsdfSample& s) {
        sum += static_cast<double>(s.weight.y * s.eta_scale) / 40000;
    });
    return sum;
}

}  // namespace

TEST_CASE("conductor: reflectance at normal incidence, without absorption, and at grazing") {
    for (const double eta : {0.2, 1.0, 1.5, 3.0})
        for (const double k : {0.0, 0.5, 4.0}) {
            CAPTURE(eta);
            CAPTURE(k);
            const double exact = ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k);
            const auto e = static_cast<Real>(eta), kappa = static_cast<Real>(k);
            CHECK(fresnel_conductor(1, e, kappa) == doctest::Approx(exact).epsilon(1e-4));
            CHECK(fresnel_conductor(Real(1e-5), e, kappa) == doctest::Approx(1).epsilon(1e-2));
            for (const double cosine : {0.1, 0.4, 0.8})
                if (k == 0)
                    CHECK(fresnel_conductor(static_cast<Real>(cosine), e, 0) ==
                          doctest::Approx(fresnel_dielectric(static_cast<Real>(cosine), e))
                              .epsilon(1e-3)
                              .scale(1));
        }
}

TEST_CASE("conductor: every named metal has an index of its own, and reflects what it should") {
    for (const auto& row : EnumTable<ConductorMetal>::rows) {
        CAPTURE(row.name);
        Material m;
        m.metal = row.value;
        m.eta = m.k = {2, 2, 2};
        const ConductorIndex index = index_of(m);
        CHECK((index.eta == m.eta) == (row.value == ConductorMetal::Custom));
        const Vec3 f = fresnel_conductor(1, Vec3(index.eta), Vec3(index.k));
        CHECK((max_component(f) < 1 && f.x > Real(0.3)));
        if (row.value == ConductorMetal::Gold) CHECK((f.x > Real(0.9) && f.z < Real(0.5)));
        if (row.value == ConductorMetal::Silver) CHECK(f.z > Real(0.85));
    }
}

TEST_CASE("facets: samples follow the density, weights are eval over it") {
    const double level = sidak(0.01, 3 * 2 * 3 * 3 * 2);
    for_rough([&](const Bsdf& b, Vec3 wo) {
        for (const Vec3 axis : {Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
            if (b.kind == MaterialKind::Conductor && axis.z < 0) continue;
            const Chi2 chi2 = chi2_test_directions(
                DirectionGrid{axis, 1}, kSamples,
                [&](Vec2 u, Real u3) { return bsdf_sample(b, wo, u, u3).wi; },
                [&](Vec3 wi) { return bsdf_pdf(b, wo, wi); });
            CHECK(chi2.p_value > level);
        }
        int wrong = 0;
        for_samples(b, wo, 20000, [&](const BsdfSample& s) {
            if (is_black(s.weight)) return;
            const Real pdf = bsdf_pdf(b, wo, s.wi);
            const Real given_back = bsdf_eval(b, wo, s.wi).y;
            wrong += !(tp::abs(pdf - s.pdf) <= Real(1e-3) * max(pdf, Real(1)));
            wrong += !(tp::abs(given_back - s.weight.y * pdf) <= Real(2e-3) * max(pdf, Real(1)));
        });
        CHECK(wrong == 0);
    });
}

TEST_CASE("facets: what single scattering gives back is at most all of it") {
    for_rough([](const Bsdf& b, Vec3 wo) { CHECK(albedo(b, wo) < 1.005); });
    // Smooth ones lose nothing.
    CHECK(albedo(facets(MaterialKind::Conductor, 0), tilted(40)) > 0.99);
    CHECK(albedo(facets(MaterialKind::Dielectric, 0.04), tilted(40)) ==
          doctest::Approx(1).epsilon(0.005));
}

TEST_CASE("facets: compensation makes the white furnace white") {
    const AlbedoTables tables = albedo_arrays().view();
    for (const double alpha : {0.1, 0.36, 0.8}) {
        for (const double degrees : {0.0, 40.0, 75.0}) {
            CAPTURE(alpha);
            CAPTURE(degrees);
            const Vec3 wo = tilted(degrees);
            const auto a = static_cast<Real>(alpha);
            Bsdf metal = facets(MaterialKind::Conductor, alpha);
            const Vec2 e = ggx_albedo(tables, wo.z, a);
            metal.facets.gain = conductor_gain(metal.facets.eta, metal.facets.k, e.x + e.y);
            CHECK(albedo(metal, wo) == doctest::Approx(1).epsilon(0.01));
            for (const double eta : {1.5, 1 / 1.5}) {
                CAPTURE(eta);
                Bsdf glass = facets(MaterialKind::Dielectric, alpha, eta);
                glass.facets.gain = Vec3(1 / glass_albedo(tables, wo.z, a, static_cast<Real>(eta)));
                CHECK(albedo(glass, wo) == doctest::Approx(1).epsilon(0.015));
            }
        }
    }
}

TEST_CASE("facets: light may be followed backwards") {
    for_rough([](const Bsdf& b, Vec3 wo) {
        for (const double degrees : {20.0, 65.0}) {
            const Vec3 wi = tilted(degrees, 2);
            CHECK(bsdf_eval(b, wo, wi).y / wi.z ==
                  doctest::Approx(bsdf_eval(b, wi, wo).y / wo.z).epsilon(1e-3));
        }
    });
}
