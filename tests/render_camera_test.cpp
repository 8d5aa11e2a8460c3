// Camera rays: field of view, thin lens, clip planes, far-off cameras.
#include "support/scene_maker.h"

#include <teapath/kernel/camera_ray.h>

#include <cmath>
#include <initializer_list>

using namespace tp;
using namespace tp::test;

namespace {
CameraRecord record_of(const Scene& scene) {
    SceneArrays arrays;
    flatten(scene, SceneParts::All, arrays);
    return arrays.camera;
}
constexpr double kDegrees = 180 / 3.14159265358979323846;
}  // namespace

TEST_CASE("E18: the field of view is exact to 1e-4 degrees") {
    for (const double fov : {1.0, 20.0, 45.0, 60.0, 90.0, 120.0}) {
        SceneMaker maker;
        maker.scene.render.width = 400;
        maker.scene.render.height = 400;
        maker.camera().vertical_fov = fov;
        const CameraRecord camera = record_of(maker.scene);
        const Vec3 top = camera_ray(camera, {200, 0}, 400, 400, {0, 0}).direction;
        const Vec3 bottom = camera_ray(camera, {200, 400}, 400, 400, {0, 0}).direction;
        const double angle =
            2 * std::atan2(length(top - bottom) / 2.0, length(top + bottom) / 2.0) * kDegrees;
        CHECK(std::abs(angle - fov) < 1e-4 + 1e-6 * fov);
    }
}

TEST_CASE("the picture's right is along look direction x up, its top is up") {
    SceneMaker maker;
    maker.camera().look_from = {1, 2, 3};
    maker.camera().look_at = {4, 2, 3};  // along +x: right is +z
    const CameraRecord camera = record_of(maker.scene);
    const Vec3 right = camera_ray(camera, {64, 24}, 64, 48, {0, 0}).direction;
    CHECK(right.z > 0.3);
    CHECK(camera_ray(camera, {32, 0}, 64, 48, {0, 0}).direction.y > 0.3);
}

TEST_CASE("R3: what lies in the plane of focus is sharp, the blur circle obeys the thin lens") {
    // A small light at distance z; the lens of diameter a is focused at distance f. On the plane of
    // focus its image is a disk of diameter a * |f - z| / z.
    SceneMaker maker;
    maker.camera().look_from = {0, 0, 0};
    maker.camera().look_at = {0, 0, -1};
    maker.camera().aperture = 0.5;
    maker.camera().focus_distance = 4;
    maker.camera().vertical_fov =
        2 * std::atan(1.0 / 4) * kDegrees;  // 2 units high at the plane of focus
    maker.scene.render.width = 200;
    maker.scene.render.height = 200;
    // The image is the blur disk convolved with the light's own disk, radius 0.08 on the plane of
    // focus; second moments of radiance add, and that of a disk is half its squared radius.
    const auto blur_diameter = [&](double z) {
        SceneMaker with;
        with.scene = maker.scene;
        with.sphere({0, 0, -z}, 0.02 * z, with.light(1));
        const FilmImage film = render(with.scene, 256);
        double sum = 0, moment = 0;
        for (int y = 0; y < 200; ++y) {
            for (int x = 0; x < 200; ++x) {
                const double dx = (x + 0.5 - 100) / 100, dy = (y + 0.5 - 100) / 100,
                             value = red(film, x, y);
                sum += value;
                moment += value * (dx * dx + dy * dy);
            }
        }
        return 2 * std::sqrt(2 * std::max(0.0, moment / sum - 0.08 * 0.08 / 2));
    };
    CHECK(blur_diameter(4) < 0.02);
    for (const double z : {2.0, 8.0})
        CHECK(blur_diameter(z) == doctest::Approx(0.5 * std::abs(4 - z) / z).epsilon(0.02));
}

TEST_CASE("orthographic: a ball covers its disk, wherever it stands") {
    SceneMaker maker;
    maker.camera().look_from = {0, 0, 10};
    maker.camera().projection = ProjectionKind::Orthographic;
    maker.camera().film_height = 4;
    for (const double z : {0.0, 5.0, -100.0}) {
        SceneMaker with;
        with.scene = maker.scene;
        with.sphere({0.3, 0.2, z}, 1, with.light(1));
        const double share = 3.14159265 / (4 * 4 * 64.0 / 48);
        CHECK(mean(render(with.scene, 64)) == doctest::Approx(share).epsilon(0.005));
    }
}

TEST_CASE("panoramas: directions by angle; a fisheye is black beyond its circle") {
    Scene scene = SceneMaker().scene;
    scene.render.width = 200;
    scene.render.height = 100;
    scene.cameras[0].look_from = {0, 0, 0};
    scene.cameras[0].look_at = {0, 0, -1};
    scene.cameras[0].projection = ProjectionKind::Equirectangular;
    CameraRecord camera = record_of(scene);
    const auto near = [](Vec3 a, Vec3 b) { return length(a - b) < Real(1e-5); };
    CHECK(near(camera_ray(camera, {100, 50}, 200, 100, {0, 0}).direction, {0, 0, -1}));
    CHECK(near(camera_ray(camera, {150, 50}, 200, 100, {0, 0}).direction, {1, 0, 0}));
    CHECK(near(camera_ray(camera, {0, 50}, 200, 100, {0, 0}).direction, {0, 0, 1}));
    CHECK(near(camera_ray(camera, {70, 0}, 200, 100, {0, 0}).direction, {0, 1, 0}));

    scene.cameras[0].projection = ProjectionKind::Fisheye;
    scene.cameras[0].vertical_fov = 180;
    camera = record_of(scene);
    CHECK(near(camera_ray(camera, {100, 0}, 200, 100, {0, 0}).direction, {0, 1, 0}));
    CHECK(near(camera_ray(camera, {150, 50}, 200, 100, {0, 0}).direction, {1, 0, 0}));
    const Vec3 slanted = camera_ray(camera, {125, 50}, 200, 100, {0, 0}).direction;
    CHECK(slanted.x == doctest::Approx(std::sqrt(0.5)));
    CHECK_FALSE(camera_ray(camera, {151, 50}, 200, 100, {0, 0}).is_on_film);

    scene.background.color = Double3(1);
    const FilmImage film = render(scene, 4);
    CHECK(red(film, 100, 50) == doctest::Approx(1));
    CHECK(red(film, 20, 50) == 0);
}

TEST_CASE("shift: the film moves and nothing else") {
    SceneMaker maker;
    CameraRecord camera = record_of(maker.scene);
    const Vec3 before = camera_ray(camera, {48, 12}, 64, 48, {0, 0}).direction;
    maker.camera().shift = {0.25, 0.25};
    camera = record_of(maker.scene);
    CHECK(length(camera_ray(camera, {32, 24}, 64, 48, {0, 0}).direction - before) < Real(1e-6));
}

TEST_CASE("aperture: blades make a regular polygon, evenly lit") {
    CameraRecord camera;
    camera.blades = 6;
    double moment = 0;
    int outside = 0;
    constexpr int kSide = 300;
    for (int i = 0; i < kSide * kSide; ++i) {
        const Vec2 u{(static_cast<Real>(i % kSide) + Real(0.5)) / kSide,
                     (static_cast<Real>(i / kSide) + Real(0.5)) / kSide};
        const Vec2 p = sample_aperture(camera, u);
        moment += static_cast<double>(p.x * p.x + p.y * p.y) / (kSide * kSide);
        // Corners at the top and at the bottom: flat sides left and right.
        outside += std::abs(p.x) > Real(0.8661) || std::abs(p.y) > Real(1.0001);
    }
    CHECK(outside == 0);
    // The second moment of a regular polygon with circumradius 1: (2 + cos(2 pi / n)) / 6.
    CHECK(moment == doctest::Approx((2 + 0.5) / 6).epsilon(1e-3));
}

TEST_CASE("clip planes cut along the view axis") {
    SceneMaker maker;
    maker.camera().look_from = {0, 0, 10};
    maker.sphere({0, 0, 0}, 1, maker.light(1));
    maker.sphere({0, 0, 5}, 1, maker.light(0.5));
    CHECK(red(render(maker.scene, 4), 32, 24) == doctest::Approx(0.5));
    maker.camera().near_clip = 7;
    CHECK(red(render(maker.scene, 4), 32, 24) == doctest::Approx(1));
    maker.camera().far_clip = 8;
    CHECK(red(render(maker.scene, 4), 32, 24) == 0);
}

TEST_CASE("a camera a million units away still sees a clean picture") {
    SceneMaker maker;
    maker.camera().look_from = {0, 0, 1e6};
    maker.camera().vertical_fov = 2 * std::atan(2.0 / 1e6) * kDegrees;
    maker.background(1);
    maker.sphere({0, 0, 0}, 1, maker.lambertian(0.5));
    const FilmImage film = render(maker.scene, 64);
    CHECK(red(film, 32, 24) == doctest::Approx(0.5).epsilon(1e-4));
    CHECK(red(film, 1, 1) == doctest::Approx(1));
    // 48 pixels are 4 units: the sphere covers pi (12)^2 of 64 x 48 pixels.
    CHECK(mean(film) == doctest::Approx(1 - 0.5 * 3.14159265 * 144 / (64 * 48)).epsilon(0.01));
}
