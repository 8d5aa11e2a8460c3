// Radiance that is no number: it is counted and never gets into the film, whatever brings it.
#include "support/scene_maker.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>

using namespace tp;
using namespace tp::test;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinite = std::numeric_limits<float>::infinity();

// One texel of RGBA, as an OpenEXR file may hold it.
ImageFile texel(float red, float alpha = 1) {
    auto image = std::make_shared<Image>();
    const float values[4] = {red, 0.5f, 0.5f, alpha};
    *image = {1, 1, 4, PixelFormat::F32, std::vector<std::byte>(sizeof values)};
    std::memcpy(image->bytes.data(), values, sizeof values);
    return {"test.exr", std::move(image)};
}

TextureId add_texture(SceneMaker& maker, float red, float alpha = 1) {
    Texture t;
    t.kind = TextureKind::Image;
    t.file = texel(red, alpha);
    return maker.texture(t);
}

struct Outcome {
    FilmImage film;
    std::vector<uint8_t> display;
    RenderCounters counters;
};

Outcome outcome_of(const Scene& scene, int64_t samples = 40) {
    Session session(session_options(true));
    session.sync(std::make_shared<const Scene>(scene));
    REQUIRE(session.step(samples));
    return {session.film(), session.display(), session.counters()};
}

bool all_finite(const std::vector<float>& values) {
    return std::all_of(values.begin(), values.end(), [](float x) { return std::isfinite(x); });
}

void check_finite(const FilmImage& film) {
    CHECK(all_finite(film.radiance));
    CHECK(all_finite(film.standard_error));
    CHECK(all_finite(film.alpha));
    CHECK(all_finite(film.albedo));
    CHECK(all_finite(film.normal));
    CHECK(all_finite(film.depth));
}

// A ball in the middle of the picture before a grey background.
SceneMaker ball(const std::function<void(SceneMaker&, Material&)>& change) {
    SceneMaker maker;
    maker.background(0.5);
    Material m;
    change(maker, m);
    maker.sphere({0, 0, 0}, 1, maker.material(m));
    return maker;
}

}  // namespace

TEST_CASE("NaN, infinite and huge texels: every sample that meets them is black and counted") {
    for (const float bad : {kNan, kInfinite, -kInfinite, 3e38f, 2e14f}) {
        CAPTURE(bad);
        {  // a light's image
            const SceneMaker maker = ball([&](SceneMaker& s, Material& m) {
                m.kind = MaterialKind::DiffuseLight;
                m.emission.texture = add_texture(s, bad);
            });
            const Outcome o = outcome_of(maker.scene);
            check_finite(o.film);
            const auto covered = static_cast<double>(o.counters.invalid_samples) /
                                 static_cast<double>(o.counters.samples);
            CHECK(covered > 0.05);
            CHECK(covered < 0.5);
            CHECK(red(o.film, 32, 24) == 0);
            CHECK(red(o.film, 0, 0) == 0.5);
            CHECK(o.display[3 * (24 * 64 + 32)] == 0);
        }
        {  // the background's image
            SceneMaker maker;
            maker.scene.background.kind = BackgroundKind::Image;
            maker.scene.background.file = texel(bad);
            const Outcome o = outcome_of(maker.scene);
            check_finite(o.film);
            CHECK(mean(o.film) == 0);
            CHECK(o.counters.invalid_samples == o.counters.samples);
        }
    }
}

TEST_CASE("colours and alpha that are no numbers reach neither radiance nor feature planes") {
    for (const float bad : {kNan, kInfinite, 3e38f}) {
        CAPTURE(bad);
        for (const MaterialKind kind :
             {MaterialKind::Lambertian, MaterialKind::Metal, MaterialKind::Dielectric}) {
            CAPTURE(static_cast<int>(kind));
            const SceneMaker maker = ball([&](SceneMaker& s, Material& m) {
                m.kind = kind;
                m.color.texture = add_texture(s, bad);
            });
            const Outcome o = outcome_of(maker.scene);
            check_finite(o.film);
            CHECK(o.counters.invalid_samples > 0);
            CHECK(red(o.film, 0, 0) == 0.5);
        }
        check_finite(outcome_of(ball([&](SceneMaker& s, Material& m) {
                                    m.color.texture = add_texture(s, 0.5f, bad);
                                }).scene)
                         .film);
    }
}

TEST_CASE("the strongest light that a scene may have fits the film") {
    SceneMaker maker;
    maker.background(kMaxRadiance);
    const Outcome o = outcome_of(maker.scene, 200);
    CHECK(o.counters.invalid_samples == 0);
    check_finite(o.film);
    CHECK(red(o.film, 3, 3) == doctest::Approx(kMaxRadiance).epsilon(1e-5));
}

TEST_CASE(
    "black samples leave the mean of the others as it is: no sample is counted twice or lost") {
    // Half of the picture shows NaN, the other half light.
    SceneMaker maker;
    Material good, bad;
    good.kind = bad.kind = MaterialKind::DiffuseLight;
    bad.emission.texture = add_texture(maker, kNan);
    maker.object(XyRectShape{{-9, -9}, {0, 9}, 0}, maker.material(good));
    maker.object(XyRectShape{{0, -9}, {9, 9}, 0}, maker.material(bad));
    maker.camera().look_from = {0, 0, 5};
    const Outcome o = outcome_of(maker.scene);
    CHECK(o.counters.invalid_samples == o.counters.samples / 2);
    CHECK(red(o.film, 10, 24) == 1);
    CHECK(red(o.film, 50, 24) == 0);
}
