// The time line: there for scenes that move, plays and scrubs, and is no step of the history.
#include "../support/animated_gltf.h"
#include "window_test.h"

#include <teapath/io/scene_file.h>
#include <teapath/scene/pose.h>

#include <doctest/doctest.h>

using namespace tp;
using namespace tp::test;

namespace {

Scene animated_scene(const ModelFolder& folder) {
    folder.write("a.gltf", "{\"asset\": {\"version\": \"2.0\"}, " + animated_json() + "}");
    Scene scene = load_scene(folder.path / "a.gltf");
    scene.render.samples = 2;
    return scene;
}

}  // namespace

TEST_CASE("timeline: nothing is shown for a scene that does not move") {
    WindowTest t;
    t.frames(3);
    t.run([](ImGuiTestContext* ctx) {
        CHECK_FALSE(ctx->ItemExists("//Viewport/##time"));
        CHECK_FALSE(ctx->ItemExists("//Viewport/##play"));
    });
}

TEST_CASE("timeline: it plays, loops and holds, and the picture follows") {
    const ModelFolder folder;
    WindowTest t(animated_scene(folder), 700, 480);
    REQUIRE(t.frames_until([&] { return t.app->status.samples >= 1; }));
    const auto shown = [&] { return t.app->status.posed ? t.app->status.posed->render.time : -1; };
    CHECK(shown() == 0);
    const size_t steps = t.app->document.history().size();
    t.run([&](ImGuiTestContext* ctx) {
        ctx->ItemClick("//Viewport/###play");
        CHECK(WindowTest::yield_until(ctx, [&] { return t.scene().render.time > 0.2; }));
        CHECK(WindowTest::yield_until(ctx, [&] { return shown() > 0.2; }));
        // Round the end.
        t.app->ui.timeline.position = 1.9;
        CHECK(WindowTest::yield_until(ctx, [&] { return t.scene().render.time < 1; }));
        ctx->ItemClick("//Viewport/###play");
        CHECK_FALSE(t.app->ui.timeline.is_playing);
        const double held = t.scene().render.time;
        ctx->Yield(20);
        CHECK(t.scene().render.time == held);
        // Without the loop it stops at the end.
        ctx->ItemClick("//Viewport/###loop");
        ctx->ItemClick("//Viewport/###play");
        t.app->ui.timeline.position = 1.95;
        CHECK(WindowTest::yield_until(ctx, [&] { return !t.app->ui.timeline.is_playing; }));
        CHECK(t.scene().render.time == doctest::Approx(2));
        CHECK(WindowTest::yield_until(ctx, [&] { return shown() == t.scene().render.time; }));
        // From there it begins anew.
        ctx->ItemClick("//Viewport/###play");
        CHECK(WindowTest::yield_until(ctx, [&] { return t.scene().render.time < 1; }));
        t.app->ui.timeline.is_playing = false;
    });
    CHECK(t.app->document.history().size() == steps);
    CHECK(t.gl_errors == 0);
}

TEST_CASE("timeline: scrubbing goes to frames, and undo leaves the time alone") {
    const ModelFolder folder;
    WindowTest t(animated_scene(folder), 700, 480);
    REQUIRE(t.frames_until([&] { return t.app->status.samples >= 1; }));
    t.app->document.edit("Hide", "", [](Scene& s) { s.objects.edit()[0].visible = false; });
    const size_t steps = t.app->document.history().size();
    t.run([](ImGuiTestContext* ctx) { ctx->ItemInputValue("//Viewport/##time", 1.01f); });
    CHECK(t.scene().render.time == doctest::Approx(1));
    CHECK(t.app->document.is_modified());
    CHECK(t.app->document.history().size() == steps);
    t.app->document.undo();
    CHECK(t.scene().objects[0].visible);
    CHECK(t.scene().render.time == doctest::Approx(1));
    CHECK(t.frames_until([&] {
        return t.app->status.posed && t.app->status.posed->render.time == t.scene().render.time;
    }));
    t.screenshot("timeline");
}
