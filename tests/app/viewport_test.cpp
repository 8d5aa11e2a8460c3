// The viewport beyond flying: orbit, pan, focus, bookmarks, the gizmo, size and zoom of the
// picture, the keys' settings and the first start's card.
#include "actions.h"
#include "fly_camera.h"
#include "viewport/bookmarks.h"
#include "window_test.h"

#include <GLFW/glfw3.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace tp;
using namespace tp::test;

namespace {

ImVec2 middle() {
    return ImGui::FindWindowByName("Viewport")->InnerClipRect.GetCenter();
}

void focus_picture(ImGuiTestContext* ctx) {
    ctx->WindowFocus("//Viewport");
    ctx->MouseMoveToPos(middle());
    ctx->Yield(2);
}

// Drags from the middle of the picture with a button and modifiers held.
void drag(ImGuiTestContext* ctx, int button, int modifiers, const ImVec2& by) {
    focus_picture(ctx);
    if (modifiers) ctx->KeyDown(modifiers);
    ctx->MouseDown(button);
    ctx->Yield(2);
    ctx->MouseMoveToPos({middle().x + by.x / 2, middle().y + by.y / 2});
    ctx->MouseMoveToPos({middle().x + by.x, middle().y + by.y});
    ctx->MouseUp(button);
    if (modifiers) ctx->KeyUp(modifiers);
    ctx->Yield(2);
}

// The scene is there for tracing.
void wait_for_scene(WindowTest& t) {
    CHECK(t.frames_until([&] { return t.app->status.is_done; }));
}

const Object& object(const WindowTest& t, uint32_t id) {
    return *find(t.scene(), ObjectId{id});
}

// How often the colour changes from one pixel of the screen to the next along 300 of them.
int changes_along_middle(WindowTest& t) {
    int width = 0, height = 0;
    const std::vector<uint8_t> pixels = t.draw_and_read(width, height);
    int changes = 0;
    const int x = static_cast<int>(middle().x) - 150, y = static_cast<int>(middle().y) + 3;
    for (int i = 0; i < 300; ++i) {
        const auto at = static_cast<size_t>(3 * (y * width + x + i));
        changes += !std::equal(&pixels[at], &pixels[at + 3], &pixels[at + 3]);
    }
    return changes;
}

// Where the ball in the middle is met by the ray through the middle of the picture.
double distance_of_middle(const WindowTest& t) {
    return glm::distance(t.camera().look_from, t.camera().look_at) - 0.5;
}

}  // namespace

TEST_CASE("viewport: the first start's card goes with the first key, for good") {
    WindowTest t;
    t.app->ui.preferences.seen_welcome = false;
    t.frames(5);
    t.screenshot("welcome");
    t.press_key(GLFW_KEY_LEFT_SHIFT, true);
    t.frames(2);
    t.press_key(GLFW_KEY_LEFT_SHIFT, false);
    t.frames(2);
    CHECK(t.app->ui.preferences.seen_welcome);
    // What the next start reads.
    CHECK(load_preferences(configuration_folder() / "settings.json").seen_welcome);
}

TEST_CASE("viewport: it has the keyboard from the start") {
    WindowTest t;
    t.frames(12);
    CHECK(t.app->ui.viewport.has_focus);
    const Camera before = t.camera();
    t.press_key(GLFW_KEY_W, true);
    t.frames(10);
    t.press_key(GLFW_KEY_W, false);
    t.frames(2);
    CHECK(t.camera().look_from != before.look_from);
}

TEST_CASE("viewport: Alt-drag orbits about what is under the pointer, middle-drag pans") {
    WindowTest t;
    wait_for_scene(t);
    t.run([&](ImGuiTestContext* ctx) {
        const Camera before = t.camera();
        const Double3 pivot = before.look_from + axes_of(before).forward * distance_of_middle(t);
        drag(ctx, 0, ImGuiMod_Alt, {100, 0});
        const Camera after = t.camera();
        CHECK(glm::distance(after.look_from, before.look_from) > 0.5);
        // The pointer is on a whole pixel, the middle may lie between two.
        CHECK(glm::distance(after.look_from, pivot) ==
              doctest::Approx(glm::distance(before.look_from, pivot)).epsilon(1e-3));
        CHECK(t.app->document.selection.empty());  // no click
        drag(ctx, 2, 0, {60, 30});
        CHECK(glm::distance(t.camera().look_from, after.look_from) > 0.05);
        CHECK(glm::distance(t.camera().look_at - t.camera().look_from,
                            after.look_at - after.look_from) < 1e-9);
        CHECK(t.app->document.history().size() == 1);
    });
}

TEST_CASE("viewport: a drag is no click") {
    WindowTest t;
    wait_for_scene(t);
    t.run([&](ImGuiTestContext* ctx) {
        const Camera before = t.camera();
        drag(ctx, 0, 0, {40, 0});
        ctx->Yield(4);
        CHECK(t.app->document.selection.empty());
        CHECK(t.camera() == before);
    });
}

TEST_CASE("viewport: Ctrl+Alt+click and the focus tool set the distance that is sharp") {
    WindowTest t;
    wait_for_scene(t);
    t.run([&](ImGuiTestContext* ctx) {
        const double expected = distance_of_middle(t);
        focus_picture(ctx);
        ctx->KeyDown(ImGuiMod_Ctrl | ImGuiMod_Alt);
        ctx->MouseClick(0);
        ctx->KeyUp(ImGuiMod_Ctrl | ImGuiMod_Alt);
        WindowTest::yield_until(
            ctx, [&] { return t.camera().focus_distance > 0; }, 2);
        CHECK(t.camera().focus_distance == doctest::Approx(expected).epsilon(1e-4));
        CHECK(t.app->document.selection.empty());
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiKey_Z);
        CHECK(t.camera().focus_distance == 0);
        focus_picture(ctx);
        ctx->KeyPress(ImGuiKey_O);
        ctx->MouseClick(0);
        WindowTest::yield_until(
            ctx, [&] { return t.camera().focus_distance > 0; }, 2);
        CHECK(t.camera().focus_distance == doctest::Approx(expected).epsilon(1e-4));
    });
}

TEST_CASE("viewport: Esc selects nothing, gives the pointer free, and never quits") {
    WindowTest t;
    wait_for_scene(t);
    t.run([&](ImGuiTestContext* ctx) {
        focus_picture(ctx);
        t.app->document.select({2});
        ctx->KeyPress(ImGuiKey_Escape);
        CHECK(t.app->document.selection.empty());
    });
    const ImVec2 at = middle();
    t.app->document.select({2});
    t.move_cursor(at.x, at.y);
    t.frames(2);
    t.press_mouse(GLFW_MOUSE_BUTTON_RIGHT, true);
    t.frames(3);
    CHECK(t.app->ui.viewport.is_looking);
    CHECK(glfwGetInputMode(t.glfw(), GLFW_CURSOR) == GLFW_CURSOR_DISABLED);
    t.press_key(GLFW_KEY_ESCAPE, true);
    t.frames(3);
    t.press_key(GLFW_KEY_ESCAPE, false);
    t.frames(2);
    CHECK_FALSE(t.app->ui.viewport.is_looking);
    CHECK(glfwGetInputMode(t.glfw(), GLFW_CURSOR) == GLFW_CURSOR_NORMAL);
    CHECK(t.app->document.selection.size() == 1);  // one thing at a time
    t.press_mouse(GLFW_MOUSE_BUTTON_RIGHT, false);
    t.frames(2);
    CHECK_FALSE(t.app->is_closed());
}

TEST_CASE("viewport: bookmarks are set, gone to and undone by keys") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        focus_picture(ctx);
        const Camera first = t.camera();
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiKey_3);
        CHECK(find_bookmark(t.scene(), 3));
        ctx->KeyDown(ImGuiKey_W);
        ctx->Yield(20);
        ctx->KeyUp(ImGuiKey_W);
        ctx->Yield(2);
        const Camera flown = t.camera();
        CHECK(flown.look_from != first.look_from);
        ctx->KeyPress(ImGuiKey_3);
        CHECK(t.camera().look_from == first.look_from);
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiKey_Z);
        CHECK(t.camera().look_from == flown.look_from);
        ctx->KeyPress(ImGuiKey_4);  // not set
        CHECK(t.camera().look_from == flown.look_from);
    });
}

TEST_CASE("viewport: framing shows the selection, and C leads back") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        focus_picture(ctx);
        const Camera before = t.camera();
        t.app->document.select({4});
        ctx->KeyPress(ImGuiKey_F);
        CHECK(glm::distance(t.camera().look_at, Double3(1.2, 0.5, 0)) < 1e-9);
        ctx->KeyPress(ImGuiKey_Home);
        CHECK(glm::distance(t.camera().look_at, Double3(0, 0.5, 0)) < 1e-9);
        ctx->KeyPress(ImGuiKey_C);
        CHECK(t.camera() == before);
    });
}

TEST_CASE("viewport: the gizmo moves several objects at once and scales a sphere as a sphere") {
    WindowTest t;
    wait_for_scene(t);
    t.run([&](ImGuiTestContext* ctx) {
        // The two outer balls: their middle is the middle of the picture.
        t.app->document.select({2});
        t.app->document.select({4}, true);
        focus_picture(ctx);
        ctx->KeyPress(ImGuiKey_G);
        drag(ctx, 0, 0, {60, 0});
        const Double3 a = object(t, 2).transform.translation;
        CHECK(glm::length(a) > 0.1);
        CHECK(glm::distance(a, object(t, 4).transform.translation) < 1e-9);
        CHECK(t.app->document.history().size() == 2);  // one drag, one step
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiKey_Z);
        CHECK(object(t, 2).transform == Transform{});

        t.app->document.selection = {{3}};
        focus_picture(ctx);
        ctx->KeyPress(ImGuiKey_T);
        drag(ctx, 0, 0, {60, 0});
        const Double3 scale = object(t, 3).transform.scale;
        CHECK(scale.x > 1.1);
        CHECK(scale.x == scale.y);
        CHECK(scale.y == scale.z);
        CHECK(glm::distance(
                  Double3(world_from_object(object(t, 3).transform) * Double4(0, 0.5, 0, 1)),
                  Double3(0, 0.5, 0)) < 1e-5);
    });
    t.screenshot("gizmo");
}

TEST_CASE("viewport: the gizmo goes in steps where snapping is on") {
    WindowTest t;
    wait_for_scene(t);
    t.run([&](ImGuiTestContext* ctx) {
        t.app->document.select({3});
        t.app->ui.viewport.move_step = 0.25f;
        focus_picture(ctx);
        ctx->KeyPress(ImGuiKey_G);
        ctx->KeyPress(ImGuiKey_M);
        CHECK(t.app->ui.viewport.snap);
        drag(ctx, 0, 0, {90, 0});
        const double x = object(t, 3).transform.translation.x;
        CHECK(x > 0.2);
        CHECK(std::abs(x / 0.25 - std::round(x / 0.25)) < 1e-4);
    });
}

TEST_CASE("viewport: the picture has the panel's size, or the scene file's with zoom") {
    WindowTest t;
    wait_for_scene(t);
    CHECK(t.app->texture.width() > 300);
    t.run([&](ImGuiTestContext* ctx) {
        ViewportState& v = t.app->ui.viewport;
        t.between_frames(ctx, [&] {
            PanelContext c = t.context();
            run_action("view.fixed_size", c);
        });
        CHECK(WindowTest::yield_until(
            ctx, [&] { return t.app->texture.width() == 64 && t.app->texture.height() == 36; },
            20));
        CHECK(v.width == 64);
        focus_picture(ctx);
        ctx->KeyDown(ImGuiMod_Shift);
        for (int i = 0; i < 6; ++i)
            ctx->MouseWheelY(1);
        ctx->KeyUp(ImGuiMod_Shift);
        CHECK(v.view.zoom > kPixelGridZoom);
        CHECK(t.camera().vertical_fov == 40);  // the wheel zoomed the picture alone
        const Double2 shift = v.view.shift;
        drag(ctx, 2, ImGuiMod_Shift, {30, 10});
        CHECK(glm::distance(v.view.shift, shift) > 10);
        CHECK(t.camera() == active_camera(*t.app->document.history().front().scene));
        t.between_frames(ctx, [&] {
            t.screenshot("pixel_grid");
            CHECK(changes_along_middle(t) < 80);
        });
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiKey_0);
        CHECK(v.view == PictureView{});
    });
}

TEST_CASE("keys: a key is changed in the settings, acts at once, is kept and can be reset") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        focus_picture(ctx);
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiKey_Comma);
        ctx->SetRef("//Settings");
        ctx->ItemClick("settings/Keys");
        ctx->ItemInputValue("**/##search", "pause");
        ctx->ItemClick("**/###render.pause0");
        CHECK(t.app->ui.dialogs.key_to_set == "render.pause");
        ctx->KeyPress(ImGuiKey_J);
        CHECK(t.app->ui.dialogs.key_to_set.empty());
        CHECK(t.app->ui.keys.chords("render.pause")[0] == ImGuiKey_J);
        CHECK_FALSE(t.app->ui.paused);  // the key was only taken
        CHECK(t.app->ui.preferences.keys.count("render.pause") == 1);

        // The new key acts, the old one no longer.
        focus_picture(ctx);
        ctx->KeyPress(ImGuiKey_P);
        CHECK_FALSE(t.app->ui.paused);
        ctx->KeyPress(ImGuiKey_J);
        CHECK(t.app->ui.paused);
        ctx->KeyPress(ImGuiKey_J);

        // Esc leaves the key as it is; a conflict is named; all is reset.
        ctx->SetRef("//Settings");
        ctx->ItemClick("**/###render.pause0");
        ctx->KeyPress(ImGuiKey_Escape);
        CHECK(t.app->ui.keys.chords("render.pause")[0] == ImGuiKey_J);
        CHECK(t.app->ui.dialogs.show_settings);
        ctx->ItemClick("**/###render.pause0");
        ctx->KeyPress(ImGuiKey_F);
        CHECK(t.app->ui.keys.conflicts("render.pause", ImGuiKey_F) ==
              std::vector<std::string>{"camera.frame_selection"});
        t.between_frames(ctx, [&] { t.screenshot("settings_keys"); });
        ctx->ItemClick("**/Reset all");
        CHECK(t.app->ui.preferences.keys.empty());
    });
    // Names in the settings file lead to the same keys.
    KeyMap keys;
    keys.set("fly.down", {ImGuiKey_LeftCtrl, 0});
    keys.set("edit.redo", {ImGuiMod_Ctrl | ImGuiMod_Alt | ImGuiKey_Z, ImGuiKey_F9});
    KeyMap again;
    again.from_names(keys.to_names());
    CHECK(again.chords("fly.down") == keys.chords("fly.down"));
    CHECK(again.chords("edit.redo") == keys.chords("edit.redo"));
}

TEST_CASE("keys: what edits text in a field does nothing else") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        t.app->document.edit("Change", "", [](Scene& s) { s.name = "Other"; });
        ctx->ItemClick("//Console/##filter");
        ctx->KeyChars("word");
        for (const ImGuiKey key : {ImGuiKey_A, ImGuiKey_Z})
            ctx->KeyPress(ImGuiMod_Ctrl | key);
        CHECK(t.app->document.selection.empty());
        CHECK(t.scene().name == "Other");
    });
}

TEST_CASE("settings: theme and scale act at once") {
    WindowTest t;
    t.frames(3);
    const auto font_size = [] { return ImGui::FindWindowByName("Options")->FontRefSize; };
    const float size = font_size();
    t.app->ui.preferences.interface_scale = 2 * t.app->window.scale();
    t.frames(3);
    CHECK(font_size() == doctest::Approx(2 * size));
    t.app->ui.preferences.dark_theme = false;
    t.frames(2);
    CHECK(font_size() == doctest::Approx(2 * size));
    CHECK(ImGui::GetStyleColorVec4(ImGuiCol_WindowBg).x > 0.7f);
    t.app->ui.preferences.interface_scale = 0;
    t.app->ui.preferences.dark_theme = true;
    t.frames(3);
    CHECK(font_size() == doctest::Approx(size));
}
