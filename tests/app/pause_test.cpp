// Pausing: the picture holds, an edit still shows at once, and the renderer rests.
#include "window_test.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

using namespace tp;
using namespace tp::test;

namespace {

Scene long_scene() {
    Scene scene = small_scene();
    scene.render.samples = 100000;
    return scene;
}

bool fills_panel(const WindowTest& t) {
    return t.app->texture.width() == t.app->ui.viewport.width &&
           t.app->texture.height() == t.app->ui.viewport.height;
}

}  // namespace

TEST_CASE("pause: samples stop, and go on from where they were") {
    WindowTest t(long_scene(), 700, 480);
    REQUIRE(t.frames_until([&] { return t.app->status.samples >= 3 && fills_panel(t); }));
    t.context().set_paused(true);
    // The step under way may end.
    REQUIRE(t.frames_until([&] { return t.app->status.is_resting; }));
    t.frames(1);
    const int64_t held = t.app->status.samples;
    const std::vector<uint8_t> before = t.app->texture.pixels();
    t.frames(120);
    CHECK(t.app->status.samples == held);
    CHECK(t.app->texture.pixels() == before);
    t.context().set_paused(false);
    CHECK(t.frames_until([&] { return t.app->status.samples > held; }));
}

TEST_CASE("pause: an edit shows at once and then holds; undo shows the old picture") {
    WindowTest t(long_scene(), 700, 480);
    REQUIRE(t.frames_until([&] { return t.app->status.samples >= 1 && fills_panel(t); }));
    t.context().set_paused(true);
    t.frames(30);
    const auto mean_red = [&] {
        const std::vector<uint8_t> pixels = t.app->texture.pixels();
        double sum = 0;
        for (size_t i = 0; i < pixels.size(); i += 3)
            sum += pixels[i] - pixels[i + 2];
        return sum / static_cast<double>(pixels.size() / 3);
    };
    const double before = mean_red();
    t.app->document.edit("Red floor", "", [](Scene& s) {
        s.materials.edit()[0].color.color = {0.9, 0, 0};
    });
    CHECK(t.frames_until([&] { return mean_red() > before + 20; }));
    t.frames(30);
    const int64_t held = t.app->status.samples;
    t.frames(120);
    CHECK(t.app->status.samples == held);
    t.app->document.undo();
    CHECK(t.frames_until([&] { return mean_red() < before + 10; }));
}

TEST_CASE("pause: closing while rendering takes less than half a second") {
    auto t = std::make_unique<WindowTest>(long_scene());
    REQUIRE(t->frames_until([&] { return t->app->status.samples >= 1; }));
    const double seconds = t->close();
    CHECK(seconds < 0.5);
}
