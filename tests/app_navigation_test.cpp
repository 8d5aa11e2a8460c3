// Flying by keys and mouse, frame by frame (T35, T36, T42).
#include "app/fly_camera.h"
#include "app/viewport/navigation.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace tp;

namespace {

using Key = NavigationInput::Key;

// A viewport with the focus and the pointer over it; a user who presses and releases things.
struct User {
    NavigationState state;
    NavigationSettings settings{2, 0.1, 720};
    NavigationInput in;
    Camera camera;

    User() {
        camera.look_from = {0, 1, 4};
        camera.look_at = {0, 1, 0};
        in.is_hovered = in.has_focus = true;
        in.seconds = 1.0 / 60;
    }
    Key& key(FlyKey k) { return in.keys[static_cast<size_t>(k)]; }
    static void press(Key& k) { k = {true, true}; }
    static void release(Key& k) { k = {}; }

    NavigationResult frame(const Double2& delta = {0, 0}, double wheel = 0) {
        in.mouse_delta = delta;
        in.wheel = wheel;
        const NavigationResult result = navigate(state, in, settings, camera);
        camera = result.camera;
        settings.fly_speed = result.fly_speed;
        for (Key* k : {&in.left, &in.middle, &in.right, &in.down_by_ctrl})
            k->pressed = false;
        for (Key& k : in.keys)
            k.pressed = false;
        in.other_key_pressed = false;
        return result;
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i)
            frame();
    }
    Double3 moved_by(int count) {
        const Double3 start = camera.look_from;
        frames(count);
        return camera.look_from - start;
    }
};

double error(const Double3& a, const Double3& b) {
    return glm::distance(a, b);
}

}  // namespace

TEST_CASE("T35: each key moves by speed times time in its direction, whatever the frame rate") {
    const struct {
        FlyKey key;
        Double3 direction;
    } keys[] = {{FlyKey::Forward, {0, 0, -1}}, {FlyKey::Back, {0, 0, 1}},
                {FlyKey::Left, {-1, 0, 0}},    {FlyKey::Right, {1, 0, 0}},
                {FlyKey::Up, {0, 1, 0}},       {FlyKey::Down, {0, -1, 0}}};
    for (const auto& [key, direction] : keys) {
        for (const int rate : {15, 60, 240, 1000}) {
            User user;
            user.in.seconds = 1.0 / rate;
            User::press(user.key(key));
            CHECK(error(user.moved_by(rate), direction * 2.0) < 1e-9);
            User::release(user.key(key));
            CHECK(user.moved_by(10) == Double3(0, 0, 0));
        }
    }
}

TEST_CASE(
    "T35: left Shift flies faster, opposite keys hold still, two keys are no faster than one") {
    User user;
    User::press(user.key(FlyKey::Forward));
    User::press(user.key(FlyKey::Faster));
    CHECK(error(user.moved_by(60), {0, 0, -2 * kFasterFactor}) < 1e-9);
    User::release(user.key(FlyKey::Faster));
    User::press(user.key(FlyKey::Right));
    CHECK(glm::length(user.moved_by(60)) == doctest::Approx(2));
    User::release(user.key(FlyKey::Right));
    User::press(user.key(FlyKey::Back));
    CHECK(user.moved_by(10) == Double3(0, 0, 0));
}

TEST_CASE("T35: keys act only with the focus, and never while typing") {
    User user;
    user.in.has_focus = false;
    for (const FlyKey k : {FlyKey::Forward, FlyKey::Up, FlyKey::Left})
        User::press(user.key(k));
    CHECK(user.moved_by(30) == Double3(0, 0, 0));
    user.in.has_focus = true;
    user.in.is_typing = true;
    CHECK(user.moved_by(30) == Double3(0, 0, 0));
    // What was typed does not fly when the field loses the keyboard before the key is up.
    user.in.is_typing = false;
    CHECK(user.moved_by(30) == Double3(0, 0, 0));
}

TEST_CASE("Ctrl with a letter is a shortcut and never flies") {
    for (const bool looking : {false, true}) {
        User user;
        if (looking) User::press(user.in.right);
        user.frame();
        user.in.ctrl = true;
        User::press(user.in.down_by_ctrl);
        User::press(user.key(FlyKey::Back));  // Ctrl+S in one frame
        user.in.other_key_pressed = true;
        CHECK(user.moved_by(60) == Double3(0, 0, 0));
        // Ctrl is let go first: the letter is still the shortcut's.
        user.in.ctrl = false;
        User::release(user.in.down_by_ctrl);
        CHECK(user.moved_by(60) == Double3(0, 0, 0));
        User::release(user.key(FlyKey::Back));
        user.frame();
        User::press(user.key(FlyKey::Back));
        CHECK(glm::length(user.moved_by(60)) == doctest::Approx(2));
    }
}

TEST_CASE("left Ctrl alone flies down after 0.15 s, and at once while the right button is held") {
    User user;
    user.in.seconds = 0.01;
    user.in.ctrl = true;
    User::press(user.in.down_by_ctrl);
    CHECK(user.moved_by(15) == Double3(0, 0, 0));
    CHECK(error(user.moved_by(50), {0, -1, 0}) < 0.03);
    // A shortcut ends it.
    user.in.other_key_pressed = true;
    CHECK(user.moved_by(50) == Double3(0, 0, 0));

    User looking;
    looking.in.seconds = 0.01;
    User::press(looking.in.right);
    looking.frame();
    looking.in.ctrl = true;
    User::press(looking.in.down_by_ctrl);
    CHECK(error(looking.moved_by(50), {0, -1, 0}) < 1e-9);
}

TEST_CASE("right-drag looks, and only while the button is held over the picture") {
    User user;
    user.frame({50, 50});
    CHECK(user.camera.look_at == Double3(0, 1, 0));
    User::press(user.in.right);
    user.frame();
    user.frame({3, 0});    // the capture's
    user.frame({100, 0});  // 10 degrees to the right
    const Double3 view = glm::normalize(user.camera.look_at - user.camera.look_from);
    CHECK(std::atan2(view.x, -view.z) * 180 / 3.14159265358979323846 == doctest::Approx(10));
    CHECK(user.camera.look_from == Double3(0, 1, 4));
    CHECK(glm::distance(user.camera.look_from, user.camera.look_at) == doctest::Approx(4));
    User::release(user.in.right);
    const Camera rest = user.camera;
    user.frame({500, -300});  // the pointer comes back where it was
    CHECK(user.camera == rest);

    user.in.is_hovered = false;
    User::press(user.in.right);
    user.frame();
    user.frame({40, 40});
    user.frame({40, 40});
    CHECK(user.camera == rest);
}

TEST_CASE("T42: a thousand focus clicks with jumps of the pointer never move the camera") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> jump(-2000, 2000);
    User user;
    const Camera start = user.camera;
    for (int click = 0; click < 1000; ++click) {
        user.in.has_focus = click % 2 == 0;
        Key& button = click % 3 == 0   ? user.in.left
                      : click % 3 == 1 ? user.in.right
                                       : user.in.middle;
        User::press(button);
        user.in.has_focus = true;
        // The jump comes with the press, or one frame late, or both, then the button is up.
        if (click % 4 != 0) user.frame({jump(random), jump(random)});
        if (&button == &user.in.right && click % 4 == 1)
            user.frame({jump(random), jump(random)});
        else
            user.frame();
        User::release(button);
        user.frame({jump(random), jump(random)});
    }
    CHECK(user.camera == start);
}

TEST_CASE(
    "the wheel changes the field of view within 1 to 120 degrees, or the speed while looking") {
    User user;
    user.camera.vertical_fov = 45;
    user.frame({0, 0}, 1);
    CHECK(user.camera.vertical_fov == 44);
    user.frame({0, 0}, -200);
    CHECK(user.camera.vertical_fov == 120);
    user.frame({0, 0}, 500);
    CHECK(user.camera.vertical_fov == 1);
    CHECK(user.settings.fly_speed == 2);
    User::press(user.in.right);
    user.frame();
    const NavigationResult result = user.frame({0, 0}, 2);
    CHECK(result.fly_speed == doctest::Approx(2 * 1.44));
    CHECK(user.camera.vertical_fov == 1);
    User::release(user.in.right);
    user.in.is_hovered = false;
    user.frame({0, 0}, -3);
    CHECK(user.camera.vertical_fov == 1);
}

TEST_CASE("Alt-drag orbits about the traced pivot: its distance and place in the picture stay") {
    User user;
    user.in.alt = true;
    User::press(user.in.left);
    user.frame();
    CHECK(user.state.wants_pivot);
    user.frame({20, 0});  // not answered yet: nothing turns
    CHECK(user.camera.look_from == Double3(0, 1, 4));
    user.state.pivot = {0.5, 0.8, 1};
    user.state.has_pivot = true;
    const auto seen_at = [&] {
        const CameraAxes axes = axes_of(user.camera);
        const Double3 to = user.state.pivot - user.camera.look_from;
        return Double3(glm::dot(to, axes.right), glm::dot(to, axes.up), glm::dot(to, axes.forward));
    };
    const Double3 before = seen_at();
    user.frame({120, 40});
    user.frame({-10, 25});
    CHECK(error(seen_at(), before) < 1e-9);
    CHECK(glm::distance(user.camera.look_from, Double3(0, 1, 4)) > 0.5);
}

TEST_CASE("middle-drag pans: the traced point follows the pointer") {
    User user;
    User::press(user.in.middle);
    user.frame();
    user.state.pivot = {0.3, 1.2, -2};
    user.state.has_pivot = true;
    const auto pixel = [&] {
        const CameraAxes axes = axes_of(user.camera);
        const Double3 to = user.state.pivot - user.camera.look_from;
        const double scale =
            360 / std::tan(user.camera.vertical_fov * 3.14159265358979323846 / 360);
        const double depth = glm::dot(to, axes.forward);
        return Double2(glm::dot(to, axes.right), -glm::dot(to, axes.up)) * scale / depth;
    };
    const Double2 before = pixel();
    user.frame({35, -12});
    CHECK(glm::distance(pixel() - before, Double2(35, -12)) < 1e-9);
}

TEST_CASE("Esc gives the pointer free until the buttons are up") {
    User user;
    CHECK(!release_pointer(user.state));
    User::press(user.in.right);
    user.frame();
    user.frame({1, 1});
    CHECK(release_pointer(user.state));
    const Camera rest = user.camera;
    user.frame({90, 90});
    CHECK(user.camera == rest);
    User::release(user.in.right);
    user.frame();
    CHECK(user.state.drag == Drag::None);
}

TEST_CASE("a camera that looks nowhere, or straight up, still flies and stays finite") {
    User user;
    user.camera.look_at = user.camera.look_from;
    User::press(user.key(FlyKey::Forward));
    user.frames(5);
    CHECK(std::isfinite(glm::length(user.camera.look_from + user.camera.look_at)));
    user.camera.look_at = user.camera.look_from + user.camera.up;
    User::press(user.in.right);
    user.frame();
    user.frame({1, 0});
    user.frame({30, 4000});
    user.frame({30, -4000});
    CHECK(std::isfinite(glm::length(user.camera.look_from + user.camera.look_at)));
    CHECK(glm::length(glm::cross(user.camera.look_at - user.camera.look_from, user.camera.up)) > 0);
}
