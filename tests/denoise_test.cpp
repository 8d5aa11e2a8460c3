// The denoiser: pictures come closer to those of many samples, what has no noise stays, and where
// the library is missing there is a sentence. Tests that need it say so where it is not.
#include "support/scene_maker.h"

#include <teapath/core/error.h>
#include <teapath/denoise/denoiser.h>
#include <teapath/render/denoised.h>
#include <teapath/render/rendered_image.h>

#include <cmath>
#include <limits>

using namespace tp;
using namespace tp::test;

namespace {

bool is_here() {
    const std::string why = Denoiser::why_missing();
    if (!why.empty()) MESSAGE(why);
    return why.empty();
}

// A room with a lamp: noise everywhere.
Scene room() {
    SceneMaker maker;
    maker.scene.render.width = 96;
    maker.scene.render.height = 72;
    const MaterialId grey = maker.lambertian(0.7);
    maker.object(BoxShape{{-4, -1, -4}, {4, 4, 6}}, grey).inside_out = true;
    maker.sphere({0, 0, 0}, 1, maker.lambertian(0.4));
    maker.sphere({2, 2.5, 1}, 0.3, maker.light(20));
    return maker.scene;
}

double squared_error(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        // What is seen: bright lamps count no more than white.
        const double x = std::min(static_cast<double>(a[i]), 1.0);
        sum += std::pow(x - std::min(static_cast<double>(b[i]), 1.0), 2);
    }
    return sum;
}

FilmImage cleaned(FilmDenoiser& denoiser, const Session& session, double strength,
                  DenoiseQuality quality) {
    FilmImage film = session.film();
    denoiser.clean(session, film, strength, quality);
    return film;
}

}  // namespace

TEST_CASE("denoiser: a picture of 16 samples comes closer to that of 1,024") {
    if (!is_here()) return;
    const Scene scene = room();
    const FilmImage exact = render(scene, 1024);
    Session session(session_options());
    session.sync(std::make_shared<const Scene>(scene));
    REQUIRE(session.step(16));
    FilmDenoiser denoiser;
    const double before = squared_error(session.film().radiance, exact.radiance);
    for (const DenoiseQuality quality : {DenoiseQuality::Live, DenoiseQuality::Final}) {
        const FilmImage clean = cleaned(denoiser, session, 1, quality);
        CHECK(squared_error(clean.radiance, exact.radiance) < 0.25 * before);
    }
    // Half of the strength is the mean of both, none of it the noisy one.
    const FilmImage clean = cleaned(denoiser, session, 1, DenoiseQuality::Final);
    const FilmImage half = cleaned(denoiser, session, 0.5, DenoiseQuality::Final);
    const FilmImage none = cleaned(denoiser, session, 0, DenoiseQuality::Final);
    const FilmImage noisy = session.film();
    CHECK(none.radiance == noisy.radiance);
    for (size_t i = 0; i < noisy.radiance.size(); i += 97)
        CHECK(half.radiance[i] ==
              doctest::Approx((noisy.radiance[i] + clean.radiance[i]) / 2).epsilon(1e-4));
}

TEST_CASE("denoiser: what has no noise stays, at any size, and no number is too strange") {
    if (!is_here()) return;
    Denoiser denoiser(false);
    CHECK(denoiser.name().find("Open Image Denoise 2") == 0);
    for (const auto& size :
         {std::pair{1, 1}, std::pair{3, 5}, std::pair{64, 48}, std::pair{7, 2}}) {
        const auto count = static_cast<size_t>(3 * size.first * size.second);
        const std::vector<float> grey(count, 0.4f), up(count, 0.5f);
        for (const DenoiseQuality quality : {DenoiseQuality::Live, DenoiseQuality::Final}) {
            const std::vector<float> clean =
                denoiser.run({size.first, size.second, grey, grey, up}, quality);
            REQUIRE(clean.size() == count);
            // A network is not exact, at the edges of a picture least.
            double mean = 0;
            for (const float v : clean)
                mean += static_cast<double>(v) / static_cast<double>(count);
            CHECK(mean == doctest::Approx(0.4).epsilon(size.first < 32 ? 0.3 : 0.02));
        }
    }
    std::vector<float> strange(3 * 32 * 32, 0.2f);
    strange[0] = std::numeric_limits<float>::quiet_NaN();
    strange[10] = std::numeric_limits<float>::infinity();
    strange[20] = -5;
    strange[30] = 1e30f;
    for (const float v : denoiser.run({32, 32, strange, strange, strange}, DenoiseQuality::Final))
        REQUIRE(std::isfinite(v));
    for (const float v : denoiser.run({32, 32, strange, {}, {}}, DenoiseQuality::Live))
        REQUIRE(std::isfinite(v));
}

TEST_CASE("denoiser: files hold the picture without noise, an EXR both") {
    Scene scene = room();
    Session session(session_options());
    session.sync(std::make_shared<const Scene>(scene));
    REQUIRE(session.step(4));
    const RenderedImage plain = rendered_image(session, scene, "room", {"a.png", "a.exr"}, 1);
    CHECK(plain.noisy.empty());
    scene.render.denoise = true;
    const RenderedImage image = rendered_image(session, scene, "room", {"a.png", "a.exr"}, 1);
    if (!is_here()) {
        // A warning, and the picture as it is.
        CHECK(image.display == plain.display);
        return;
    }
    CHECK(image.noisy == plain.film.radiance);
    CHECK(image.film.radiance != plain.film.radiance);
    CHECK(image.display == display_bytes(image.film, scene.display, 3));
    CHECK(image.metadata.count("denoiser") == 1);
    // Bytes of a film are those that a backend makes.
    CHECK(display_bytes(plain.film, scene.display, 3) == plain.display);
}

TEST_CASE("denoiser: a film that is emptied has guides of its own") {
    if (!is_here()) return;
    auto scene = std::make_shared<Scene>(room());
    Session session(session_options());
    session.sync(scene);
    REQUIRE(session.step(4));
    const uint64_t first = session.film_number();
    FilmDenoiser denoiser;
    CHECK(cleaned(denoiser, session, 1, DenoiseQuality::Live).samples == 4);
    auto smaller = std::make_shared<Scene>(*scene);
    smaller->render.width = 40;
    session.sync(smaller);
    CHECK(session.film_number() != first);
    REQUIRE(session.step(2));
    const FilmImage film = cleaned(denoiser, session, 1, DenoiseQuality::Live);
    CHECK(film.width == 40);
    CHECK(film.radiance.size() == size_t{3} * 40 * 72);
    CHECK(session.guides(2).albedo.size() == film.radiance.size());
    CHECK(session.guides(2).normal.size() == film.radiance.size());
}
