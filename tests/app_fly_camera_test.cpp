// Extreme input to the camera: whatever comes, a scene can hold the camera, and it looks somewhere.
#include "app/fly_camera.h"
#include "app/viewport/navigation.h"

#include <teapath/editor/refusal.h>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace tp;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();
const std::vector<double> kNumbers = {0,     -0.0, 1e-300, 1e-30, 1,         -1,         200,
                                      -1e10, 1e15, 1e30,   1e300, kInfinite, -kInfinite, kNan};

std::string why_not(const Camera& camera) {
    return refusal(std::vector<Camera>{camera});
}

// Usual cameras, and such as are just about allowed.
std::vector<Camera> cameras() {
    std::vector<Camera> list(6);
    list[1].look_from = {1e15, 0, 0};
    list[1].look_at = {-1e15, 0, 0};
    list[2].look_from = {1e9, 1e9, 1e9};  // the nearest look_at that is another place
    list[2].look_at = {std::nextafter(1e9, 0), 1e9, 1e9};
    list[3].look_from = {0, 1e-14, 0};
    list[3].look_at = {1e-14, 0, 0};
    list[4].look_from = {0, 0, 0};
    list[4].look_at = {1e-8, -1, 0};  // almost straight down
    list[5].up = {1e-14, 1e-14, 0};
    return list;
}

}  // namespace

TEST_CASE("camera: no input makes one that a scene cannot hold") {
    for (const Camera& camera : cameras()) {
        REQUIRE(why_not(camera) == "");
        for (const double a : kNumbers)
            for (const double b : kNumbers) {
                CAPTURE(a);
                CAPTURE(b);
                CHECK(why_not(fly(camera, {.forward = 1, .speed = a, .seconds = b})) == "");
                CHECK(why_not(fly(camera, {.yaw = a, .pitch = b})) == "");
                CHECK(why_not(fly(camera, {.right = a, .up = b, .yaw = 1, .seconds = 0.1})) == "");
                CHECK(why_not(orbit(camera, {a, b, 0}, 30, 20)) == "");
                CHECK(why_not(orbit(camera, {1, 2, 3}, a, b)) == "");
                CHECK(why_not(pan(camera, {a, 1}, b, 2)) == "");
                CHECK(why_not(pan(camera, {1, 1}, 720, a)) == "");
                CHECK(why_not(frame(camera, {a, 0, 0}, b)) == "");
                CHECK(why_not(frame(camera, {1, 2, 3}, 1, a)) == "");
                CHECK(why_not(widened(camera, a)) == "");
            }
    }
}

TEST_CASE("camera: a speed that is none does not keep one from looking around") {
    const Camera camera;
    const Camera looked = fly(camera, {.yaw = 10, .speed = kNan, .seconds = 0.1});
    CHECK(looked.look_from == camera.look_from);
    CHECK(looked.look_at != camera.look_at);
}

TEST_CASE("camera: far from the origin it goes on looking where it looked") {
    Camera camera;
    camera.look_from = {0, 0, 0};
    camera.look_at = {0.6, 0, 0.8};
    const Double3 view = camera.look_at;
    for (int i = 0; i < 100; ++i)
        camera = fly(camera, {.right = 1, .speed = 1e12, .seconds = 0.25});
    CHECK(glm::length(camera.look_from) > 1e13);
    CHECK(glm::distance(axes_of(camera).forward, view) < 1e-6);
    CHECK(why_not(camera) == "");
}

TEST_CASE("camera: a user with broken devices, frame by frame") {
    std::mt19937 random(11);
    const auto below = [&](size_t count) {
        return std::uniform_int_distribution<size_t>(0, count - 1)(random);
    };
    const auto any = [&] { return kNumbers[below(kNumbers.size())]; };
    for (Camera camera : cameras()) {
        NavigationState state;
        NavigationSettings settings;
        for (int i = 0; i < 3000; ++i) {
            NavigationInput in;
            in.is_hovered = in.has_focus = true;
            in.seconds = any();
            in.mouse_delta = {any(), any()};
            in.wheel = any();
            in.alt = below(4) == 0;
            for (auto* key : {&in.left, &in.middle, &in.right, &in.keys[0], &in.keys[2]})
                *key = {below(2) == 0, below(8) == 0};
            state.pivot = {any(), any(), any()};
            state.has_pivot = true;
            settings.picture_height = any();
            const NavigationResult result = navigate(state, in, settings, camera);
            camera = result.camera;
            settings.fly_speed = result.fly_speed;
            REQUIRE(why_not(camera) == "");
            REQUIRE((settings.fly_speed >= 1e-4 && settings.fly_speed <= 1e6));
        }
    }
}
