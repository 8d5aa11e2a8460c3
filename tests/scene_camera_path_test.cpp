// Cameras between cameras: through every bookmark, smooth, and once round.
#include <teapath/scene/camera_path.h>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace tp;

namespace {

Scene with_bookmarks(int count) {
    Scene scene;
    Camera camera;
    camera.id = {1};
    camera.name = "main";
    scene.cameras = {camera};
    for (int n = count; n >= 1; --n) {
        camera.id = {static_cast<uint32_t>(n) + 1};
        camera.name = fmt::format("bookmark {}", n);
        camera.look_from = {n * 1.0, n * n * 0.5, 4.0 - n};
        camera.vertical_fov = 30 + 5 * n;
        scene.cameras.push_back(camera);
    }
    return scene;
}

}  // namespace

TEST_CASE("camera path: bookmarks by their numbers, other cameras left out") {
    const auto keys = bookmark_cameras(with_bookmarks(4));
    REQUIRE(keys.size() == 4);
    for (size_t i = 0; i < 4; ++i)
        CHECK(keys[i].name == fmt::format("bookmark {}", i + 1));
    CHECK(bookmark_cameras(Scene{}).empty());
}

TEST_CASE("camera path: goes through every key and never jumps") {
    const auto keys = bookmark_cameras(with_bookmarks(4));
    for (size_t i = 0; i < 4; ++i) {
        const Camera camera = camera_on_path(keys, static_cast<double>(i) / 3);
        CHECK(glm::distance(camera.look_from, keys[i].look_from) < 1e-12);
        CHECK(camera.vertical_fov == doctest::Approx(keys[i].vertical_fov));
    }
    // Its speed has no steps either: the path is smooth in place and direction.
    const double h = 1e-4;
    Double3 last(0);
    for (double t = h; t < 1 - 2 * h; t += h) {
        const Double3 speed =
            (camera_on_path(keys, t + h).look_from - camera_on_path(keys, t).look_from) / h;
        if (t > h) CHECK(glm::distance(speed, last) < 0.05);
        last = speed;
    }
}

TEST_CASE("camera path: one key stands still, ends are clamped") {
    const auto one = bookmark_cameras(with_bookmarks(1));
    CHECK(camera_on_path(one, 0.7).look_from == one[0].look_from);
    const auto two = bookmark_cameras(with_bookmarks(2));
    CHECK(camera_on_path(two, -1).look_from == two[0].look_from);
    CHECK(glm::distance(camera_on_path(two, 2).look_from, two[1].look_from) < 1e-12);
}

TEST_CASE("turntable: keeps distance and height, a full turn comes back") {
    Camera camera;
    camera.look_from = {3, 2, 1};
    camera.look_at = {0.5, 0, 0};
    camera.up = {0, 2, 0};
    for (const double turns : {0.1, 0.25, 0.5, 0.9}) {
        const Camera turned = camera_on_turntable(camera, turns);
        CHECK(glm::distance(turned.look_from, camera.look_at) ==
              doctest::Approx(glm::distance(camera.look_from, camera.look_at)));
        CHECK(turned.look_from.y == doctest::Approx(2));
        CHECK(turned.look_from.x != doctest::Approx(3));
        CHECK(turned.look_at == camera.look_at);
    }
    CHECK(glm::distance(camera_on_turntable(camera, 1).look_from, camera.look_from) < 1e-12);
}
