// White and grey furnaces: what goes in must come out, by closed forms.
#include "support/scene_maker.h"

#include <cmath>
#include <initializer_list>

using namespace tp;
using namespace tp::test;

namespace {

// One sphere in a uniform environment of radiance 1, filling the middle of the picture.
FilmImage furnace(const std::function<MaterialId(SceneMaker&)>& make_material, double radius = 1) {
    SceneMaker maker;
    maker.background(1);
    maker.path().max_depth = 200;
    maker.sphere({0, 0, 0}, radius, make_material(maker));
    return render(maker.scene, 256);
}

// The walls of a closed sphere emit 1 and reflect `albedo`; the camera is inside.
Scene closed_furnace(double albedo) {
    SceneMaker maker;
    Material m;
    m.color.color = Double3(albedo);
    m.emits = true;
    m.emission.color = Double3(1);
    m.side = EmissionSide::Both;
    maker.sphere({0, 0, 0}, 10, maker.material(m));
    maker.path().max_depth = 4096;
    return maker.scene;
}

// What each bounce brings to the picture's mean: the difference that one more segment makes.
std::vector<double> ledger_by_bounce(Scene scene, int bounces) {
    scene.render.path.roulette_depth = 0;
    std::vector<double> ledger;
    double before = 0;
    for (int depth = 1; depth <= bounces; ++depth) {
        scene.render.path.max_depth = depth;
        const double total = mean(render(scene, 64));
        ledger.push_back(total - before);
        before = total;
    }
    return ledger;
}

}  // namespace

TEST_CASE("AC-F1: a lossless material in a white furnace is invisible") {
    const auto check_white = [](const FilmImage& film) {
        double low = 10, high = 0;
        for (const float x : film.radiance) {
            low = std::min(low, static_cast<double>(x));
            high = std::max(high, static_cast<double>(x));
        }
        CHECK(low > 0.995);
        CHECK(high < 1.005);
    };
    SUBCASE("Lambertian") {
        check_white(furnace([](SceneMaker& m) { return m.lambertian(1); }));
    }
    SUBCASE("smooth metal") {
        check_white(furnace([](SceneMaker& m) { return m.metal(1, 0); }));
    }
    SUBCASE("glass: each sample carries 1, or what roulette and depth leave of it") {
        check_white(furnace([](SceneMaker& m) { return m.glass(1.5); }));
    }
    SUBCASE("hollow glass, negative radius") {
        check_white(furnace([](SceneMaker& m) { return m.glass(1.5); }, -1));
    }
}

TEST_CASE("AC-F1: fuzzy metal loses only what scatters below the surface") {
    const FilmImage film = furnace([](SceneMaker& m) { return m.metal(1, 0.5); });
    const double centre = red(film, 32, 24);
    CHECK(centre > 0.999);  // head-on a ball of radius 0.5 stays above the surface
    CHECK(mean(film) < 1);
    for (const float x : film.radiance)
        CHECK(x < 1.01f);
}

TEST_CASE("a grey Lambertian sphere in a white furnace shows its albedo") {
    SceneMaker maker;
    maker.background(1);
    maker.sphere({0, 0, 0}, 1, maker.lambertian(0.5));
    const FilmImage film = render(maker.scene, 64);
    CHECK(red(film, 32, 24) == doctest::Approx(0.5).epsilon(1e-5));
    CHECK(red(film, 0, 0) == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("AC-F2: a closed grey furnace sums the geometric series, with roulette") {
    for (const double albedo : {0.5, 0.8, 0.95}) {
        CAPTURE(albedo);
        CHECK(mean(render(closed_furnace(albedo), 64)) ==
              doctest::Approx(1 / (1 - albedo)).epsilon(0.01));
    }
}

TEST_CASE("AC-F2: cut after 12 segments the furnace holds 12 terms, light sampling or not") {
    const double expected[] = {1.99951, 4.65640, 9.19280};
    const double albedos[] = {0.5, 0.8, 0.95};
    for (const bool light_sampling : {true, false}) {
        for (int i = 0; i < 3; ++i) {
            CAPTURE(albedos[i]);
            CAPTURE(light_sampling);
            Scene scene = closed_furnace(albedos[i]);
            scene.render.path.max_depth = 12;
            scene.render.path.roulette_depth = 0;
            scene.render.path.light_sampling = light_sampling;
            CHECK(mean(render(scene, 64)) == doctest::Approx(expected[i]).epsilon(0.005));
        }
    }
}

TEST_CASE("T26: the ledger of energy by bounce: bounce k brings albedo^k") {
    const std::vector<double> ledger = ledger_by_bounce(closed_furnace(0.7), 6);
    for (size_t k = 0; k < ledger.size(); ++k) {
        CAPTURE(k);
        CHECK(ledger[k] == doctest::Approx(std::pow(0.7, static_cast<double>(k))).epsilon(0.02));
    }
}

TEST_CASE("T26: emission ends the path of a light that scatters nothing") {
    SceneMaker maker;
    maker.sphere({0, 0, 0}, 10, maker.light(1, EmissionSide::Both));
    const std::vector<double> ledger = ledger_by_bounce(maker.scene, 4);
    CHECK(ledger[0] == 1);
    for (size_t k = 1; k < ledger.size(); ++k)
        CHECK(ledger[k] == 0);
}

TEST_CASE("T26: what metal scatters below its surface is gone, and nothing else") {
    const auto ledger = [](double fuzz) {
        SceneMaker maker;
        Material m;
        m.kind = MaterialKind::Metal;
        m.color.color = Double3(1);
        m.fuzz = fuzz;
        m.emits = true;
        m.emission.color = Double3(1);
        m.side = EmissionSide::Both;
        // From near the wall many rays graze it.
        maker.camera().look_from = {0, 0, 9.5};
        maker.camera().look_at = {0, 1, 9.5};
        maker.camera().up = {0, 0, 1};
        maker.camera().vertical_fov = 90;
        maker.scene.render.width = 32;
        maker.scene.render.height = 24;
        maker.sphere({0, 0, 0}, 10, maker.material(m));
        return ledger_by_bounce(maker.scene, 6);
    };
    for (const double brought : ledger(0))
        CHECK(brought == doctest::Approx(1).epsilon(1e-4));
    const std::vector<double> fuzzy = ledger(1);
    CHECK(fuzzy[0] == doctest::Approx(1).epsilon(1e-5));
    CHECK(fuzzy[1] < 0.99);
    CHECK(fuzzy[1] > 0.5);
    for (size_t k = 1; k < fuzzy.size(); ++k)
        CHECK(fuzzy[k] < fuzzy[k - 1]);
}

TEST_CASE(
    "T26: light is spent or escapes: with an open sky the ledger sums to what a path can meet") {
    // A white ball under a white sky: whatever the number of bounces, all light is found once.
    SceneMaker maker;
    maker.background(1);
    maker.sphere({0, 0, 0}, 1, maker.lambertian(1));
    maker.sphere({1.5, 0, 0}, 0.8, maker.lambertian(1));
    maker.sphere({-1.4, 0.2, 0}, 0.7, maker.metal(1, 0));
    maker.scene.render.width = 24;
    maker.scene.render.height = 18;
    const std::vector<double> ledger = ledger_by_bounce(maker.scene, 40);
    double sum = 0;
    for (const double brought : ledger) {
        CHECK(brought >= -1e-6);
        sum += brought;
    }
    CHECK(sum == doctest::Approx(1).epsilon(1e-3));
    CHECK(ledger.back() < 1e-4);
}

TEST_CASE("T24: every depth from 1 to 50 holds that many terms of the series") {
    Scene scene = closed_furnace(0.9);
    scene.render.width = 24;
    scene.render.height = 18;
    scene.render.path.roulette_depth = 0;
    for (int depth = 1; depth <= 50; ++depth) {
        CAPTURE(depth);
        scene.render.path.max_depth = depth;
        CHECK(mean(render(scene, 8)) ==
              doctest::Approx((1 - std::pow(0.9, depth)) / 0.1).epsilon(0.01));
    }
}

TEST_CASE("max_depth counts segments: 1 shows emission, 2 direct light") {
    SceneMaker maker;
    maker.camera().look_from = {0, 0, 5};
    maker.sphere({0, 0, 0}, 1, maker.lambertian(0.8));
    maker.sphere({0, 0, 50}, 10, maker.light(4));
    maker.path().max_depth = 1;
    CHECK(mean(render(maker.scene, 4)) == 0);
    maker.path().max_depth = 2;
    CHECK(red(render(maker.scene, 64), 32, 24) > 0);
}

TEST_CASE(
    "dispersion: glass that disperses is white in a white furnace, and coloured before stripes") {
    SceneMaker maker;
    maker.background(1);
    Material m;
    m.kind = MaterialKind::Principled;
    m.color.color = Double3(1);
    m.surface.roughness.value = 0;
    m.surface.transmission.value = 1;
    m.surface.thin = false;
    m.surface.dispersion = 3;
    maker.sphere({0, 0, 0}, 1, maker.material(m));
    maker.path().roulette_depth = 0;
    const FilmImage film = render(maker.scene, 256);
    Double3 sum(0);
    for (size_t i = 0; i < film.radiance.size(); ++i)
        sum[static_cast<int>(i % 3)] += static_cast<double>(film.radiance[i]);
    sum /= static_cast<double>(film.radiance.size() / 3);
    for (int c = 0; c < 3; ++c)
        CHECK(sum[c] == doctest::Approx(1).epsilon(0.005));

    // A light behind the ball: red and blue see it in different places.
    maker.background(0);
    maker.object(XyRectShape{{-0.6, -0.6}, {0, 0.6}, -3}, maker.light(1));
    maker.scene.objects.edit().back().camera_visible = false;
    const FilmImage split = render(maker.scene, 256);
    double differs = 0;
    for (size_t i = 0; i < split.radiance.size(); i += 3)
        differs += std::abs(static_cast<double>(split.radiance[i] - split.radiance[i + 2]));
    CHECK(differs / static_cast<double>(split.radiance.size() / 3) > 0.01);
}
