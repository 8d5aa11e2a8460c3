// What "the same image" means: splits, threads, seeds, and coverage of pixels.
#include "support/scene_maker.h"

#include <cmath>
#include <initializer_list>

using namespace tp;
using namespace tp::test;

namespace {

Scene lively_scene() {
    SceneMaker maker;
    maker.scene.background.kind = BackgroundKind::Gradient;
    maker.camera().look_from = {0, 1.5, 5};
    maker.camera().look_at = {0, 0.5, 0};
    maker.camera().aperture = 0.1;
    maker.sphere({0, -100, 0}, 100, maker.lambertian(0.5));
    maker.sphere({0, 0.5, 0}, 0.5, maker.glass(1.5));
    maker.sphere({1.1, 0.5, 0}, 0.5, maker.metal(0.8, 0.3));
    maker.sphere({-1.1, 0.5, 0}, 0.5, maker.lambertian(0.7));
    maker.object(XzRectShape{{-1, -1}, {1, 1}, 3}, maker.light(3)).inside_out = true;
    return maker.scene;
}

double relative_mse(const FilmImage& a, const FilmImage& b) {
    double sum = 0;
    const double floor = 0.01 * mean(b) * mean(b);
    for (size_t i = 0; i < a.radiance.size(); ++i) {
        const double x = static_cast<double>(a.radiance[i]), y = static_cast<double>(b.radiance[i]);
        sum += (x - y) * (x - y) / (y * y + floor);
    }
    return sum / static_cast<double>(a.radiance.size());
}

// Bit for bit on the host; on a GPU up to rounding.
void check_same(const FilmImage& a, const FilmImage& b) {
    CHECK(a.samples == b.samples);
    if (backend_name() == "host")
        CHECK(a.radiance == b.radiance);
    else
        CHECK(relative_mse(a, b) < 1e-9);
}

}  // namespace

TEST_CASE("n samples and then m more are n + m samples") {
    const auto scene = std::make_shared<const Scene>(lively_scene());
    Session whole(session_options(true)), parts(session_options(true));
    whole.sync(scene);
    parts.sync(scene);
    REQUIRE(whole.step(75));
    for (const int n : {1, 2, 30, 7, 32, 3})
        REQUIRE(parts.step(n));
    const FilmImage a = whole.film(), b = parts.film();
    check_same(a, b);
    if (backend_name() == "host") {
        CHECK(a.albedo == b.albedo);
        CHECK(a.standard_error == b.standard_error);
    }
}

TEST_CASE("the number of threads changes nothing") {
    const Scene scene = lively_scene();
    const FilmImage one = render(scene, 8, false, 1);
    check_same(one, render(scene, 8, false, 3));
    check_same(one, render(scene, 8, false, 8));
}

TEST_CASE("one seed gives one image, another seed another, and they agree on average") {
    Scene scene = lively_scene();
    const FilmImage a = render(scene, 64);
    check_same(a, render(scene, 64));
    scene.render.path.seed = 7;
    const FilmImage b = render(scene, 64);
    CHECK(a.radiance != b.radiance);
    scene.render.path.seed = uint64_t{7} | uint64_t{1} << 40;
    const FilmImage c = render(scene, 64);
    CHECK(b.radiance != c.radiance);
    CHECK(mean(a) == doctest::Approx(mean(b)).epsilon(0.01));
    CHECK(mean(a) == doctest::Approx(mean(c)).epsilon(0.01));
}

TEST_CASE("the standard error that the film reports is the one seen between seeds") {
    Scene scene = lively_scene();
    const FilmImage a = render(scene, 64);
    scene.render.path.seed = 1;
    const FilmImage b = render(scene, 64);
    double squares = 0, variances = 0;
    for (size_t i = 0; i < a.standard_error.size(); ++i) {
        const auto luminance_of = [i](const FilmImage& f) {
            return 0.2126390 * static_cast<double>(f.radiance[3 * i]) +
                   0.7151687 * static_cast<double>(f.radiance[3 * i + 1]) +
                   0.0721923 * static_cast<double>(f.radiance[3 * i + 2]);
        };
        const double d = luminance_of(a) - luminance_of(b);
        squares += d * d;
        variances += std::pow(static_cast<double>(a.standard_error[i]), 2) +
                     std::pow(static_cast<double>(b.standard_error[i]), 2);
    }
    CHECK(squares == doctest::Approx(variances).epsilon(0.25));
}

TEST_CASE("T20: a pixel's value is the covered area, without a shift by half a pixel") {
    // A white square on black that covers x > 0 and y > 0 of a film whose centre is the origin.
    SceneMaker maker;
    maker.scene.render.width = 3;
    maker.scene.render.height = 3;
    maker.camera().look_from = {0, 0, 10};
    maker.camera().vertical_fov =
        2 * std::atan(0.15) * 180 / 3.14159265358979323846;  // 3 x 3 units
    maker.object(XyRectShape{{0, 0}, {10, 10}, 0}, maker.light(1));
    const FilmImage film = render(maker.scene, 16384);
    CHECK(red(film, 1, 1) == doctest::Approx(0.25).epsilon(0.01 * 4));
    CHECK(red(film, 2, 0) == doctest::Approx(1));
    CHECK(red(film, 1, 0) == doctest::Approx(0.5).epsilon(0.02));
    CHECK(red(film, 2, 1) == doctest::Approx(0.5).epsilon(0.02));
    CHECK(red(film, 0, 2) == 0);
}

TEST_CASE("E10: odd sizes are covered to the last pixel") {
    for (const auto& [width, height] : {std::pair{1, 1}, {17, 3}, {101, 61}, {3, 40}}) {
        SceneMaker maker;
        maker.background(0.5);
        maker.scene.render.width = width;
        maker.scene.render.height = height;
        const FilmImage film = render(maker.scene, 3);
        REQUIRE(film.radiance.size() == static_cast<size_t>(3 * width * height));
        for (const float x : film.radiance)
            CHECK(x == 0.5f);
    }
}

TEST_CASE("the tree and brute force give the same image") {
    const Scene scene = lively_scene();
    const FilmImage tree = render(scene, 16);
    SceneArrays arrays;
    flatten(scene, SceneParts::All, arrays);
    arrays.brute_force = true;
    const auto backend = backend_name() == "cuda" ? make_cuda_backend(0) : make_host_backend(0);
    backend->upload(arrays, SceneParts::All);
    backend->reset_film({scene.render.width, scene.render.height, false});
    const std::atomic<bool> cancel = false;
    REQUIRE(backend->render({0, 16}, cancel));
    CHECK(relative_mse(backend->read_film(), tree) < 1e-5);
}

TEST_CASE("a cancelled step leaves an empty film and the next step works") {
    Session session(session_options());
    session.sync(std::make_shared<const Scene>(lively_scene()));
    session.cancel();
    CHECK(!session.step(4));
    CHECK(session.samples() == 0);
    CHECK(session.step(4));
    check_same(session.film(), render(lively_scene(), 4));
}

TEST_CASE("feature planes: alpha, depth, normal and ids of what the camera sees") {
    SceneMaker maker;
    maker.camera().look_from = {0, 0, 5};
    const MaterialId grey = maker.lambertian(0.25);
    maker.sphere({0, 0, 0}, 1, grey);
    maker.background(0);
    const FilmImage film = render(maker.scene, 16, true);
    const size_t centre = static_cast<size_t>(24 * 64 + 32);
    CHECK(film.alpha[centre] == 1);
    CHECK(film.alpha[0] == 0);
    CHECK(film.object_id[centre] == 1);
    CHECK(film.material_id[centre] == grey.value);
    CHECK(film.object_id[0] == 0);
    CHECK(film.depth[centre] == doctest::Approx(4).epsilon(0.001));
    CHECK(film.albedo[3 * centre] == doctest::Approx(0.25));
    CHECK(film.normal[3 * centre + 2] == doctest::Approx(1).epsilon(0.01));
}
