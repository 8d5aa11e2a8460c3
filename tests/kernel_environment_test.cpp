// Sampling of an environment image: directions follow the density, the density follows the light,
// and an estimate of the light by them has the integral's value.
#include "support/chi2.h"

#include <teapath/device/environment_arrays.h>
#include <teapath/device/srgb_table.h>
#include <teapath/kernel/environment.h>

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

using namespace tp;
using namespace tp::test;

namespace {

// A float image in grey: dim, with a few bright texels.
std::shared_ptr<const Image> sky(int width, int height) {
    Image image{width, height, 1, PixelFormat::F32, {}};
    std::vector<float> values(static_cast<size_t>(width) * static_cast<size_t>(height), 0.2f);
    values[static_cast<size_t>(height / 3 * width + width / 5)] = 400;
    values[static_cast<size_t>(height / 2 * width + width - 1)] = 50;  // at the seam
    values[0] = 30;                                                    // at the pole
    image.bytes.resize(values.size() * sizeof(float));
    std::memcpy(image.bytes.data(), values.data(), image.bytes.size());
    return std::make_shared<const Image>(std::move(image));
}

// The scene of that image alone, turned by `degrees`.
struct Sky {
    std::shared_ptr<const Image> image;
    std::shared_ptr<const EnvironmentArrays> arrays;
    std::vector<TextureRecord> textures;
    SceneView scene;

    Sky(int width, int height, double degrees)
        : image(sky(width, height)), arrays(environment_of(image, false)), textures(1) {
        ImageRecord record{};
        record.width = width;
        record.height = height;
        record.channels = 1;
        record.bytes_per_channel = 4;
        record.tint = {1, 1, 1};
        textures[0].kind = TextureKind::Image;
        textures[0].image = record;
        scene.textures = make_span(std::as_const(textures));
        scene.texels = reinterpret_cast<const unsigned char*>(image->bytes.data());
        scene.srgb_table = srgb_table().data();
        scene.environment = arrays->view();
        scene.background.kind = BackgroundKind::Image;
        scene.background.texture = 0;
        const double angle = degrees * 3.14159265358979323846 / 180;
        scene.background.cos_rotation = static_cast<Real>(std::cos(angle));
        scene.background.sin_rotation = static_cast<Real>(std::sin(angle));
    }
    Real pdf(Vec3 d) const { return environment_pdf(scene.environment, scene.background, d); }
    EnvironmentSample sample(Vec2 u) const {
        return sample_environment(scene.environment, scene.background, u);
    }
    double radiance(Vec3 d) const {
        return static_cast<double>(background_radiance<kFeatureAll>(scene, d).x);
    }
};

}  // namespace

TEST_CASE("environment: a direction's density is the one that it was sampled with") {
    for (const double degrees : {0.0, 70.0}) {
        const Sky sky(64, 32, degrees);
        const TeaKey key = tea_key(0, 4);
        int differ = 0;
        for (uint32_t i = 0; i < 20000; ++i) {
            const TeaBlock a = tea_encrypt<8>({i, 0}, key);
            const EnvironmentSample s = sky.sample({unit_real(a.v0), unit_real(a.v1)});
            REQUIRE(s.pdf > 0);
            REQUIRE(length(s.direction) == doctest::Approx(1).epsilon(1e-4));
            // On the edge of a cell rounding may choose the other side.
            differ += tp::abs(sky.pdf(s.direction) - s.pdf) > Real(1e-2) * s.pdf;
        }
        CHECK(differ < 20);
    }
}

TEST_CASE("environment: directions follow the density") {
    const Sky sky(32, 16, 25);
    double lost[2];
    const Chi2 chi2 = chi2_test_directions(
        DirectionGrid({0, 1, 0}, 2), 400000, [&](Vec2 u, Real) { return sky.sample(u).direction; },
        [&](Vec3 d) { return sky.pdf(d); }, &lost, 96);
    CAPTURE(chi2.statistic);
    CAPTURE(chi2.degrees);
    CHECK(chi2.p_value > 0.001);
    CHECK(lost[0] < 1e-4);
}

TEST_CASE("environment: a sun before the image is found as the density says") {
    Sky sky(32, 16, 25);
    sky.scene.background.sun_direction = normalize(Vec3(1, Real(0.5), Real(-0.3)));
    sky.scene.background.sun_chord2 = Real(0.1);
    sky.scene.background.sun_probability = Real(0.4);
    double lost[2];
    const Chi2 chi2 = chi2_test_directions(
        DirectionGrid({0, 1, 0}, 2), 400000, [&](Vec2 u, Real) { return sky.sample(u).direction; },
        [&](Vec3 d) { return sky.pdf(d); }, &lost, 192);
    CAPTURE(chi2.statistic);
    CAPTURE(chi2.degrees);
    CHECK(chi2.p_value > 0.001);
    CHECK(lost[0] < 1e-4);
    // The real one is small: its directions stay in its disk, up to rounding.
    const double radius = 0.265 / 180 * 3.14159265358979323846;
    sky.scene.background.sun_chord2 = static_cast<Real>(std::pow(2 * std::sin(radius / 2), 2));
    const TeaKey key = tea_key(0, 4);
    int missed = 0;
    double moment = 0;
    for (uint32_t i = 0; i < 10000; ++i) {
        const TeaBlock a = tea_encrypt<8>({i, 0}, key);
        const Vec3 d = sample_sun(sky.scene.background, {unit_real(a.v0), unit_real(a.v1)});
        missed += !meets_sun(sky.scene.background, d);
        moment += static_cast<double>(length_squared(d - sky.scene.background.sun_direction));
    }
    CHECK(missed < 50);
    CHECK(moment / 10000 == doctest::Approx(radius * radius / 2).epsilon(0.02));
}

TEST_CASE("environment: the light's integral by its samples, with little noise") {
    for (const auto& size : {std::pair{64, 32}, std::pair{5000, 40}}) {
        const Sky sky(size.first, size.second, 10);
        // By quadrature over the image.
        double integral = 0;
        constexpr int kRows = 1000, kColumns = 2000;
        for (int y = 0; y < kRows; ++y)
            for (int x = 0; x < kColumns; ++x) {
                const double theta = (y + 0.5) / kRows * 3.14159265358979323846;
                const double phi = (x + 0.5) / kColumns * 2 * 3.14159265358979323846;
                const Vec3 d(Double3(std::sin(theta) * std::sin(phi), std::cos(theta),
                                     -std::sin(theta) * std::cos(phi)));
                integral += sky.radiance(d) * std::sin(theta) * 2 * 3.14159265358979323846 *
                            3.14159265358979323846 / kRows / kColumns;
            }
        double sum = 0, squares = 0;
        constexpr uint32_t kCount = 100000;
        const TeaKey key = tea_key(0, 9);
        for (uint32_t i = 0; i < kCount; ++i) {
            const TeaBlock a = tea_encrypt<8>({i, 0}, key);
            const EnvironmentSample s = sky.sample({unit_real(a.v0), unit_real(a.v1)});
            const double value = sky.radiance(s.direction) / static_cast<double>(s.pdf);
            sum += value / kCount;
            squares += value * value / kCount;
        }
        CAPTURE(size.first);
        CHECK(sum == doctest::Approx(integral).epsilon(0.01));
        // Uniform directions would have more than ten times this deviation.
        CHECK(std::sqrt(squares - sum * sum) < 1.5 * integral);
    }
}

TEST_CASE("environment: an image is looked into once, a black one is sampled evenly") {
    const auto image = sky(16, 8);
    CHECK(environment_of(image, false) == environment_of(image, false));
    Image black{8, 4, 3, PixelFormat::U8, std::vector<std::byte>(96)};
    const auto arrays = environment_of(std::make_shared<const Image>(std::move(black)), true);
    for (const EnvironmentCell& cell : arrays->cells)
        CHECK(cell.probability == doctest::Approx(1.0 / 8));
}
