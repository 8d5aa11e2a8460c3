// Light in pictures: skies and suns by their irradiance, cones, what is hidden from some rays,
// limits of radiance, lights behind what is half transparent.
#include "device/sky_image.h"
#include "support/meshes.h"
#include "support/scene_maker.h"

#include <teapath/core/color.h>

#include <cmath>

using namespace tp;
using namespace tp::test;

namespace {

constexpr double kPiDouble = 3.14159265358979323846;

// A level sheet of that albedo that fills the picture, seen from above.
SceneMaker sheet(double albedo) {
    SceneMaker maker;
    maker.camera().look_from = {0, 4, 0};
    maker.camera().look_at = {0, 0, 0};
    maker.camera().up = {0, 0, -1};
    maker.camera().vertical_fov = 20;
    maker.object(XzRectShape{{-50, -50}, {50, 50}, 0}, maker.lambertian(albedo));
    return maker;
}

}  // namespace

TEST_CASE("sky: a level sheet gets what sky and sun give") {
    for (const double elevation : {5.0, 40.0, 85.0}) {
        CAPTURE(elevation);
        SceneMaker maker = sheet(0.5);
        Background& b = maker.scene.background;
        b.kind = BackgroundKind::Sky;
        b.sky.sun_elevation = elevation;
        const auto sky = sky_image({elevation, b.sky.haze, b.sky.ground});
        const double direct = static_cast<double>(luminance(Vec3(sky->sun_irradiance))) *
                              std::sin(elevation / 180 * kPiDouble);
        const double expected = 0.5 / kPiDouble * (direct + sky->irradiance);
        const FilmImage film = render(maker.scene, 64);
        double sum = 0;
        for (size_t i = 0; i < film.radiance.size(); i += 3)
            sum += static_cast<double>(
                luminance(Vec3(film.radiance[i], film.radiance[i + 1], film.radiance[i + 2])));
        CHECK(sum / static_cast<double>(film.radiance.size() / 3) ==
              doctest::Approx(expected).epsilon(0.02));
        // Without aiming at the sun the picture is the same, if noisier.
        maker.path().light_sampling = false;
        b.sky.sun_size = 20;
        const double blind = mean(render(maker.scene, 512));
        maker.path().light_sampling = true;
        CHECK(blind == doctest::Approx(mean(render(maker.scene, 64))).epsilon(0.03));
    }
}

TEST_CASE(
    "sky: blue above, red where the sun is low, dark at night; haze is brighter round the sun") {
    const auto up = [](const SkyImage& sky) {
        const auto* p = reinterpret_cast<const float*>(sky.image->bytes.data());
        return Double3(p[0], p[1], p[2]);
    };
    const auto noon = sky_image({60, 1, Double3(0.3)});
    CHECK(up(*noon).z > 1.5 * up(*noon).x);
    CHECK(noon->sun_irradiance.x / kPiDouble == doctest::Approx(1).epsilon(0.25));
    const auto evening = sky_image({2, 1, Double3(0.3)});
    CHECK(evening->sun_irradiance.x > 2 * evening->sun_irradiance.z);
    const auto night = sky_image({-30, 1, Double3(0.3)});
    CHECK(night->sun_irradiance == Double3(0));
    CHECK(night->irradiance < 1e-3 * noon->irradiance);
    CHECK(sky_image({60, 8, Double3(0.3)})->irradiance > noon->irradiance);
    CHECK(sky_image({60, 8, Double3(0.3)}) == sky_image({60, 8, Double3(0.3)}));
}

TEST_CASE("sun: it stands where almanacs say") {
    Sky sky;
    sky.sun_by = SunRule::Place;
    // Greenwich, the longest day, noon; the same at the equator on the day of equinox.
    sky.latitude = 51.48, sky.longitude = 0, sky.day = 172, sky.hour = 12;
    CHECK(sun_position(sky).elevation == doctest::Approx(61.9).epsilon(0.01));
    CHECK(std::abs(std::abs(sun_position(sky).azimuth) - 180) < 2);
    sky.latitude = 0, sky.day = 80, sky.hour = 12;
    CHECK(sun_position(sky).elevation > 86);
    // It rises in the east and sets in the west.
    sky.latitude = 40, sky.hour = 7;
    CHECK(std::sin(sun_position(sky).azimuth / 180 * kPiDouble) > 0.9);
    sky.hour = 17;
    CHECK(std::sin(sun_position(sky).azimuth / 180 * kPiDouble) < -0.9);
    // 90 degrees to the east it is six hours later.
    Sky east = sky;
    east.longitude = 90, east.hour = 11;
    CHECK(sun_position(east).elevation ==
          doctest::Approx(sun_position(sky).elevation).epsilon(0.02));
}

TEST_CASE("background: a tint multiplies, a backdrop is the camera's alone") {
    SceneMaker maker = sheet(0.5);
    maker.camera().look_from = {0, 1, 0};
    maker.camera().look_at = {0, 1, -1};
    maker.camera().up = {0, 1, 0};
    maker.background(2);
    maker.scene.background.backdrop = BackdropKind::Constant;
    maker.scene.background.backdrop_color = {0.25, 0.5, 0.75};
    const FilmImage film = render(maker.scene, 16);
    CHECK(red(film, 32, 2) == doctest::Approx(0.25));              // the sky
    CHECK(red(film, 32, 45) == doctest::Approx(1).epsilon(0.02));  // the sheet under it
}

TEST_CASE("spot: nothing outside of its cone, KHR_lights_punctual's fall-off within") {
    const auto picture = [](double angle, double blend) {
        SceneMaker maker = sheet(1);
        Material m;
        m.kind = MaterialKind::DiffuseLight;
        m.emission.color = Double3(1000);
        m.spot_angle = angle;
        m.spot_blend = blend;
        maker.object(DiskShape{{0, 2, 0}, {0, -1, 0}, 0.01}, maker.material(m));
        maker.scene.objects.edit().back().camera_visible = false;
        maker.camera().vertical_fov = 60;
        maker.scene.render.width = maker.scene.render.height = 65;
        maker.path().max_depth = 2;
        return render(maker.scene, 64);
    };
    const FilmImage all = picture(180, 0), cone = picture(40, 0.5);
    for (int x = 0; x < 65; ++x) {
        const double place = (x + 0.5 - 32.5) / 32.5 * 4 * std::tan(kPiDouble / 6);
        const double angle = std::atan(std::abs(place) / 2) * 180 / kPiDouble;
        const double inner = std::cos(10 * kPiDouble / 180), outer = std::cos(20 * kPiDouble / 180);
        const double share =
            std::clamp((std::cos(angle * kPiDouble / 180) - outer) / (inner - outer), 0.0, 1.0);
        CAPTURE(angle);
        if (angle > 21)
            CHECK(red(cone, x, 32) == 0);
        else if (angle < 18.5)
            CHECK(red(cone, x, 32) / red(all, x, 32) ==
                  doctest::Approx(share * share).epsilon(0.05).scale(1));
    }
}

TEST_CASE("visibility: camera, shadows and scattered light each see what they are let") {
    const auto make = [](bool camera, bool shadow, bool scattered) {
        SceneMaker maker = sheet(0.5);
        maker.background(1);
        Object& ball = maker.sphere({0, 0.5, 0}, 0.5, maker.lambertian(0));
        ball.camera_visible = camera;
        ball.casts_shadows = shadow;
        ball.reflection_visible = scattered;
        return maker;
    };
    // Before a constant sky there are no lights to aim at: scattered rays alone find it.
    const double empty = 0.5;
    CHECK(red(render(make(false, true, false).scene, 16), 32, 24) == doctest::Approx(empty));
    CHECK(red(render(make(true, true, true).scene, 16), 32, 24) == 0);
    CHECK(red(render(make(false, true, true).scene, 64), 32, 24) < 0.3 * empty);

    // A lamp's shadow.
    const auto lit = [&](bool shadow) {
        SceneMaker maker = make(false, shadow, false);
        maker.background(0);
        maker.object(XzRectShape{{-0.1, -0.1}, {0.1, 0.1}, 3}, maker.light(50)).inside_out = true;
        maker.scene.objects.edit().back().camera_visible = false;
        return red(render(maker.scene, 64), 32, 24);
    };
    CHECK(lit(false) > 0.03);
    CHECK(lit(true) < 0.02 * lit(false));

    // A lamp that scattered rays do not meet gives all of its light by being aimed at.
    SceneMaker hidden = sheet(0.5), seen = sheet(0.5);
    for (SceneMaker* maker : {&hidden, &seen}) {
        Object& lamp = maker->sphere({0, 1.5, 0}, 0.8, maker->light(2));
        lamp.camera_visible = false;
        lamp.reflection_visible = maker == &seen;
        maker->path().max_depth = 2;
    }
    CHECK(mean(render(hidden.scene, 256)) ==
          doctest::Approx(mean(render(seen.scene, 256))).epsilon(0.01));
}

TEST_CASE("clamps: direct and indirect light have limits of their own") {
    const auto brightest = [](float direct, float indirect, int depth) {
        SceneMaker maker = sheet(0.8);
        maker.object(XzRectShape{{-3, -3}, {3, 3}, 5}, maker.light(100)).inside_out = true;
        maker.scene.objects.edit().back().camera_visible = false;
        maker.path().clamp_direct = direct;
        maker.path().clamp_indirect = indirect;
        maker.path().max_depth = depth;
        return mean(render(maker.scene, 64));
    };
    const double free = brightest(0, 0, 2);
    CHECK(free > 20);
    CHECK(brightest(1, 0, 2) <= 2);
    CHECK(brightest(1, 0, 2) > 0.5);
    CHECK(brightest(0, 1, 2) == doctest::Approx(free));
    CHECK(brightest(1e6f, 1e6f, 5) == doctest::Approx(brightest(0, 0, 5)));
}

TEST_CASE("light sampling and chance agree behind what is half transparent") {
    const auto picture = [](bool sampling) {
        SceneMaker maker = sheet(0.7);
        Material veil;
        veil.color.color = Double3(0.3);
        veil.opacity = 0.4;
        veil.pass_through = {0.9, 0.6, 0.3};
        maker.object(XzRectShape{{-5, -5}, {5, 5}, 0.5}, maker.material(veil));
        maker.object(XzRectShape{{-2, -2}, {2, 2}, 1.5}, maker.light(3)).inside_out = true;
        maker.scene.objects.edit().back().camera_visible = false;
        maker.path().light_sampling = sampling;
        maker.path().max_depth = 4;
        return mean(render(maker.scene, sampling ? 256 : 2048));
    };
    CHECK(picture(true) == doctest::Approx(picture(false)).epsilon(0.01));
}

TEST_CASE("a lamp before a mesh is told from the triangle that was met behind it") {
    const auto picture = [](bool sampling) {
        SceneMaker maker = sheet(0.7);
        // Rays that reach the lamp have often met the mesh before: it is larger, and around it.
        maker.object(mesh_shape(ball_mesh(5)), maker.lambertian(0.5)).transform = {
            {0, 2.5, 0}, {0, 0, 0}, Double3(0.9)};
        for (const double x : {-1.2, 0.0, 1.2})
            maker.sphere({x, 1.2, 0}, 0.35, maker.light(3)).camera_visible = false;
        maker.scene.objects.edit()[1].camera_visible = false;
        maker.path().light_sampling = sampling;
        maker.path().max_depth = 3;
        return mean(render(maker.scene, sampling ? 256 : 2048));
    };
    CHECK(picture(true) == doctest::Approx(picture(false)).epsilon(0.01));
}
