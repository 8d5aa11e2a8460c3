// AC-F4: reflectance of dielectrics against tabulated values.
#include <teapath/kernel/bsdf/dielectric.h>

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace tp;

namespace {
Real cosine(double degrees) {
    return static_cast<Real>(std::cos(degrees * 3.14159265358979323846 / 180));
}
}  // namespace

TEST_CASE("AC-F4: exact Fresnel and Schlick for glass of 1.5") {
    CHECK(fresnel_dielectric(1, Real(1.5)) == doctest::Approx(0.04).epsilon(1e-5));
    const double degrees[] = {45, 60, 75, 85};
    const double exact[] = {0.05024, 0.08919, 0.25306, 0.61280};
    const double schlick[] = {0.04207, 0.07000, 0.25473, 0.64849};
    for (int i = 0; i < 4; ++i) {
        CHECK(std::abs(static_cast<double>(fresnel_dielectric(cosine(degrees[i]), Real(1.5))) -
                       exact[i]) < 1e-5);
        CHECK(std::abs(static_cast<double>(fresnel_schlick(cosine(degrees[i]), Real(1.5))) -
                       schlick[i]) < 1e-5);
    }
}

TEST_CASE("AC-F4: total reflection from within begins at 41.8103 degrees") {
    CHECK(fresnel_dielectric(cosine(41.80), Real(1 / 1.5)) < 1);
    CHECK(fresnel_dielectric(cosine(41.82), Real(1 / 1.5)) == 1);
    CHECK(fresnel_schlick(cosine(41.82), Real(1 / 1.5)) == 1);
}

TEST_CASE("refraction obeys Snell, reflection and transmission share the light") {
    for (const double angle : {0.0, 10.0, 30.0, 60.0, 89.0}) {
        const Real eta = Real(1.5);
        const Vec3 n{0, 0, 1};
        const Vec3 wo{std::sqrt(1 - sqr(cosine(angle))), 0, cosine(angle)};
        const Real r = fresnel_dielectric(cosine(angle), eta);
        const BsdfSample up =
            dielectric_sample(Vec3(1), eta, FresnelRule::Exact, n, wo, r * Real(0.999));
        CHECK(up.wi.z == doctest::Approx(wo.z));
        const BsdfSample down = dielectric_sample(Vec3(1), eta, FresnelRule::Exact, n, wo,
                                                  min(r * Real(1.001), Real(0.9999999)));
        CHECK(down.wi.z < 0);
        CHECK(-down.wi.x * eta == doctest::Approx(wo.x).epsilon(1e-5));
        CHECK(down.weight.x == doctest::Approx(1 / (1.5 * 1.5)));  // basic radiance
        CHECK(down.eta_scale == doctest::Approx(1.5 * 1.5));
    }
}
