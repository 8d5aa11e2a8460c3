// Where the picture lies in the viewport, what the gizmo does to transforms, and how large a scene
// is taken to be.
#include "app/fly_camera.h"
#include "app/viewport/picture_place.h"
#include "app/viewport/scene_extent.h"
#include "app/viewport/transform_edit.h"

#include <teapath/editor/document.h>

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace tp;

namespace {

const Double2 kPanel(800, 500);

double error(const Double3& a, const Double3& b) {
    return glm::distance(a, b);
}

Double3 image_of(const Transform& t, const Double3& p) {
    return Double3(world_from_object(t) * Double4(p, 1));
}

struct Dice {
    std::mt19937 random{5};
    Double3 vector(double size) {
        std::uniform_real_distribution<double> unit(-size, size);
        return {unit(random), unit(random), unit(random)};
    }
    Transform transform() {
        Transform t;
        t.translation = vector(3);
        t.rotation = vector(180);
        t.scale = glm::exp(vector(1));
        return t;
    }
    DoubleMat3 rotation() {
        Transform t;
        t.rotation = vector(180);
        return linear_part(t);
    }
};

}  // namespace

TEST_CASE("a picture of another shape is fitted into the middle of the panel") {
    const PlaceRect place = picture_place({}, {100, 50}, kPanel, {400, 100});
    CHECK(place.size == Double2(800, 200));
    CHECK(place.low == Double2(100, 200));
    CHECK(zoom_in_force({}, kPanel, {400, 100}) == 2);
    CHECK(picture_place({}, {0, 0}, kPanel, kPanel).size == kPanel);
}

TEST_CASE("zooming keeps the point under the pointer, within 1/16 and 64") {
    PictureView view;
    const Double2 pixels(1280, 720), pointer(620, 130);
    for (const double factor : {1.25, 1.25, 2.0, 0.8, 3.0, 0.5}) {
        const Double2 before = picture_point(picture_place(view, {0, 0}, kPanel, pixels), pointer);
        view = zoomed(view, factor, pointer - kPanel * 0.5, kPanel, pixels);
        const PlaceRect place = picture_place(view, {0, 0}, kPanel, pixels);
        // The place is rounded to whole pixels of the screen.
        CHECK(glm::length((picture_point(place, pointer) - before) * place.size) < 1.5);
    }
    CHECK(zoomed(view, 1e9, {0, 0}, kPanel, pixels).zoom == kHighestZoom);
    CHECK(zoomed(view, 1e-9, {0, 0}, kPanel, pixels).zoom == kLowestZoom);
}

TEST_CASE("a shifted picture never leaves the panel altogether") {
    const Double2 pixels(640, 360);
    PictureView view = shifted({}, {1e6, -1e6}, kPanel, pixels);
    const PlaceRect place = picture_place(view, {0, 0}, kPanel, pixels);
    CHECK(place.low.x < kPanel.x);
    CHECK(place.low.y + place.size.y > 0);
    // Even in a panel of a pixel.
    CHECK(std::isfinite(picture_place(view, {0, 0}, {1, 1}, {1, 1}).low.x));
}

TEST_CASE("a point of the screen and the point of the picture that it shows") {
    const PlaceRect place{{10, 20}, {200, 100}};
    CHECK(picture_point(place, {10, 20}) == Double2(0, 0));
    CHECK(picture_point(place, {110, 70}) == Double2(0.5, 0.5));
    CHECK(picture_point(place, {210, 120}) == Double2(1, 1));
}

TEST_CASE("angles taken from a rotation make it again, at the poles too") {
    Dice dice;
    for (int i = 0; i < 200; ++i) {
        Transform t;
        t.rotation = dice.vector(180);
        if (i % 5 == 0) t.rotation.y = i % 2 == 0 ? 90 : -90;
        const DoubleMat3 m = linear_part(t);
        Transform again;
        again.rotation = euler_degrees(m);
        const DoubleMat3 n = linear_part(again);
        for (int column = 0; column < 3; ++column)
            CHECK(error(m[column], n[column]) < 1e-6);
    }
}

TEST_CASE("turning about a pivot turns every point of the object about it") {
    Dice dice;
    for (int i = 0; i < 50; ++i) {
        const Transform t = dice.transform();
        const DoubleMat3 turn = dice.rotation();
        const Double3 pivot = dice.vector(2), p = dice.vector(1);
        const Double3 expected = pivot + turn * (image_of(t, p) - pivot);
        CHECK(error(image_of(turned_about(t, pivot, turn), p), expected) < 1e-6);
        CHECK(turned_about(t, pivot, turn).scale == t.scale);
    }
}

TEST_CASE("scaling about a pivot: exact along the object's own axes and where it is uniform") {
    Dice dice;
    for (int i = 0; i < 50; ++i) {
        const Transform t = dice.transform();
        const Double3 pivot = dice.vector(2), p = dice.vector(1), factor = glm::exp(dice.vector(1));
        const DoubleMat3 own = rotation_of(t);
        const Double3 in_own = glm::transpose(own) * (image_of(t, p) - pivot);
        const Double3 expected = pivot + own * (in_own * factor);
        CHECK(error(image_of(scaled_about(t, pivot, own, factor), p), expected) < 1e-6);
        const Double3 uniform = pivot + (image_of(t, p) - pivot) * 1.7;
        const Transform scaled = scaled_about(t, pivot, dice.rotation(), Double3(1.7));
        CHECK(error(image_of(scaled, p), uniform) < 1e-6);
    }
    Transform ball;
    ball = scaled_about(ball, {1, 2, 3}, DoubleMat3(1), Double3(0.3));
    CHECK(ball.scale.x == ball.scale.y);  // a sphere stays a sphere, to the bit
    CHECK(ball.scale.y == ball.scale.z);
    CHECK(scaled_about(ball, {0, 0, 0}, DoubleMat3(1), Double3(0)).scale.x > 0);
}

TEST_CASE("all of a scene is framed without its ground, in any unit") {
    for (const double unit : {0.01, 1.0, 500.0}) {
        Scene scene;
        Object ground;
        ground.id = {1};
        ground.shape = SphereShape{Double3(0, -1000, 0) * unit, 1000 * unit};
        Object ball;
        ball.id = {2};
        ball.shape = SphereShape{Double3(0, 1, 0) * unit, unit};
        Object box;
        box.id = {3};
        box.shape = BoxShape{Double3(3, 0, 0) * unit, Double3(5, 2, 1) * unit};
        scene.objects = {ground, ball, box};
        const std::optional<Extent> extent = extent_of_all(scene);
        REQUIRE(extent);
        CHECK(extent->radius < 8 * unit);
        CHECK(extent->radius > 2.5 * unit);
        // The speed grows with the unit.
        Camera camera;
        camera.id = {1};
        camera.look_from = Double3(0, 1, 8) * unit;
        camera.look_at = Double3(0, 1, 0) * unit;
        scene.cameras = {camera};
        CHECK(natural_speed(scene) > unit);
        CHECK(natural_speed(scene) < 6 * unit);
    }
    CHECK(!extent_of_all(Scene{}));
    CHECK(natural_speed(Scene{}) > 0);
}

TEST_CASE("a room whose walls are larger than what is in it is framed whole") {
    Scene scene;
    Object wall;
    wall.shape = XyRectShape{{0, 0}, {555, 555}, 555};
    Object block;
    block.shape = BoxShape{{130, 0, 65}, {295, 165, 230}};
    scene.objects = {wall, block};
    CHECK(extent_of_all(scene)->radius > 390);
}

TEST_CASE("a small lamp among larger things does not make them the ground") {
    Scene scene;
    scene.objects.edit().resize(4);
    scene.objects.edit()[0].shape = SphereShape{{0, 3, 0}, 0.02};
    for (size_t i = 1; i < 4; ++i)
        scene.objects.edit()[i].shape = SphereShape{{2.5 * static_cast<double>(i), 0, 0}, 1};
    CHECK(extent_of_all(scene)->radius > 3);
}

TEST_CASE("what a generator makes has an extent without being made") {
    Scene scene;
    Object ground;
    ground.id = {1};
    ground.shape = SphereShape{{0, -1000, 0}, 1000};
    scene.objects = {ground};
    scene.generators.edit().resize(1);
    const std::optional<Extent> quick = extent_of_all(scene);
    const std::optional<Extent> exact = extent_of_all(expand_generators(scene));
    REQUIRE(quick);
    REQUIRE(exact);
    CHECK(glm::distance(quick->center, exact->center) < 0.02 * exact->radius);
    CHECK(quick->radius == doctest::Approx(exact->radius).epsilon(0.02));
    // The largest that a scene may have: these would take gigabytes.
    scene.generators.edit()[0].grid.columns = 65535;
    scene.generators.edit()[0].grid.rows = 305;
    CHECK(extent_of_all(scene)->radius == doctest::Approx(65535 / 2.0).epsilon(0.01));
    CHECK(natural_speed(scene) > 1000);
}

TEST_CASE("framing shows the whole sphere, in narrow pictures too") {
    Camera camera;
    for (const double aspect : {0.4, 1.0, 2.0}) {
        const Double3 center(3, -1, 2);
        const Camera framed = frame(camera, center, 2.5, aspect);
        CHECK(framed.look_at == center);
        const double distance = glm::distance(framed.look_from, center);
        const double half = std::asin(2.5 / distance);
        const double room = std::atan(std::tan(framed.vertical_fov * 3.14159265358979323846 / 360) *
                                      std::min(1.0, aspect));
        CHECK(half < room);
        CHECK(half > 0.7 * room);
    }
}
