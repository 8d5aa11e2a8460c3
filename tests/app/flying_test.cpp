// The camera under keys and mouse: speed, focus, typing, looking, picking.
#include "window_test.h"

#include <GLFW/glfw3.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

using namespace tp;
using namespace tp::test;

namespace {

ImVec2 middle_of(const char* window) {
    return ImGui::FindWindowByName(window)->InnerClipRect.GetCenter();
}

void focus_picture(ImGuiTestContext* ctx) {
    ctx->WindowFocus("//Viewport");
    ctx->MouseMoveToPos(middle_of("Viewport"));
    ctx->Yield(2);
}

// Clicks a point of the picture and waits until the answer is there.
void click_picture(WindowTest& t, ImGuiTestContext* ctx, const ImVec2& offset) {
    const ImVec2 middle = middle_of("Viewport");
    ctx->MouseMoveToPos({middle.x + offset.x, middle.y + offset.y});
    const auto before = t.app->document.selection;
    ctx->MouseClick(0);
    WindowTest::yield_until(
        ctx, [&] { return t.app->document.selection != before; }, 2);
}

}  // namespace

TEST_CASE("flying: each key moves by speed times time, whatever the frame rate") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        for (const float rate : {24.0f, 60.0f, 240.0f}) {
            t.engine_io().ConfigFixedDeltaTime = 1 / rate;
            for (const Action& a : actions()) {
                if (a.scope != ActionScope::Held || std::string(a.id) == "fly.faster") continue;
                for (const int chord : t.app->ui.keys.chords(a.id)) {
                    if (chord == 0) continue;
                    INFO(std::string(a.id), " by ", chord_name(chord), " at ", rate,
                         " frames a second");
                    focus_picture(ctx);
                    ctx->KeyDown(chord);
                    // Left Ctrl waits for a letter first.
                    ctx->Yield(static_cast<int>(rate * 0.25f));
                    const Camera before = t.camera();
                    const double start = ImGui::GetTime();
                    ctx->Yield(static_cast<int>(rate / 2));
                    const double seconds = ImGui::GetTime() - start;
                    const double way = glm::distance(before.look_from, t.camera().look_from);
                    ctx->KeyUp(chord);
                    CHECK(seconds > 0.4);
                    CHECK(way ==
                          doctest::Approx(t.app->ui.viewport.fly_speed * seconds).epsilon(1e-4));
                    CHECK(t.camera().vertical_fov == before.vertical_fov);
                    t.app->document.undo();
                }
            }
        }
        t.engine_io().ConfigFixedDeltaTime = 1 / 60.0f;
    });
    CHECK(t.app->document.history().size() == 1);  // flying is no step of the history
}

TEST_CASE("flying: keys act only while the picture has the focus, and not with Ctrl") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        const Camera before = t.camera();
        for (const char* window : {"Options", "Scene", "Console"}) {
            ctx->WindowFocus((std::string("//") + window).c_str());
            for (const ImGuiKey key : {ImGuiKey_W, ImGuiKey_A, ImGuiKey_S, ImGuiKey_D, ImGuiKey_Q,
                                       ImGuiKey_E, ImGuiKey_Space, ImGuiKey_LeftCtrl, ImGuiKey_C}) {
                ctx->KeyDown(key);
                ctx->Yield(20);
                ctx->KeyUp(key);
            }
            CHECK(t.camera() == before);
            t.app->document.open(t.app->document.file());
        }
        focus_picture(ctx);
        for (const ImGuiKey key : {ImGuiKey_A, ImGuiKey_S, ImGuiKey_D}) {
            ctx->KeyDown(ImGuiMod_Ctrl | key);
            ctx->Yield(6);
            ctx->KeyUp(ImGuiMod_Ctrl | key);
            ctx->Yield(2);
            INFO(chord_name(key));
            CHECK(t.camera() == before);
        }
    });
}

TEST_CASE("flying: typing in a field never moves the camera and never pauses") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        const Camera before = t.camera();
        const char* text = "wasd qe pcf 123 PWASD";
        for (const char* field : {"//Console/##filter", "//Scene/##search"}) {
            INFO(std::string(field));
            focus_picture(ctx);
            ctx->ItemClick(field);
            ctx->KeyCharsReplace(text);
            for (const ImGuiKey key :
                 {ImGuiKey_W, ImGuiKey_P, ImGuiKey_C, ImGuiKey_F, ImGuiKey_Space,
                  ImGuiKey_LeftShift, ImGuiKey_Home, ImGuiKey_1}) {
                ctx->KeyDown(key);
                ctx->Yield(6);
                ctx->KeyUp(key);
            }
            CHECK(t.camera() == before);
            CHECK_FALSE(t.app->ui.paused);
            CHECK(std::string(ctx->ItemReadAsString(field)).find("wasd qe pcf") == 0);
            ctx->ItemInputValue(field, "");
        }
        CHECK(t.app->document.history().size() == 1);
    });
}

TEST_CASE(
    "flying: a thousand clicks for the focus, with jumps of the cursor, never move the camera") {
    WindowTest t;
    const Camera before = t.camera();
    std::mt19937 random(42);
    const auto uniform = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    t.frames_until([&] { return t.app->status.is_done; });
    for (int i = 0; i < 1000; ++i) {
        // Somewhere else, then with one jump into the picture, and a button at once.
        t.move_cursor(uniform(0, 1280), uniform(0, 720));
        if (i % 3 == 0) t.frames(1);
        const ImGuiWindow* picture = ImGui::FindWindowByName("Viewport");
        const ImRect rect = picture->InnerClipRect;
        t.move_cursor(uniform(rect.Min.x + 2, rect.Max.x - 2),
                      uniform(rect.Min.y + 2, rect.Max.y - 2));
        const int button = i % 2 == 0 ? GLFW_MOUSE_BUTTON_RIGHT : GLFW_MOUSE_BUTTON_LEFT;
        t.press_mouse(button, true);
        t.frames(1 + i % 2);
        // The first report after the cursor is caught may be anywhere.
        if (i % 5 == 0 && button == GLFW_MOUSE_BUTTON_LEFT)
            t.move_cursor(uniform(0, 1280), uniform(0, 720));
        t.press_mouse(button, false);
        t.frames(1);
        REQUIRE(t.camera() == before);
    }
    CHECK(t.app->document.history().size() == 1);
}

TEST_CASE("flying: a drag with the right button looks around and stays in place") {
    WindowTest t;
    const Camera before = t.camera();
    const ImVec2 middle = middle_of("Viewport");
    t.move_cursor(middle.x, middle.y);
    t.frames(2);
    t.press_mouse(GLFW_MOUSE_BUTTON_RIGHT, true);
    t.frames(3);
    double x = middle.x;
    for (int i = 0; i < 20; ++i) {
        t.move_cursor(x += 10, middle.y);
        t.frames(1);
    }
    const Camera looked = t.camera();
    CHECK(looked.look_from == before.look_from);
    CHECK(looked.look_at.x > before.look_at.x + 0.5);
    CHECK(looked.look_at.y == doctest::Approx(before.look_at.y));
    // Never past the poles.
    double y = middle.y;
    for (int i = 0; i < 200; ++i) {
        t.move_cursor(x, y -= 40);
        t.frames(1);
    }
    const Double3 view = glm::normalize(t.camera().look_at - t.camera().look_from);
    CHECK(view.y > 0.9);
    CHECK(view.y < 1 - 1e-7);
    t.press_mouse(GLFW_MOUSE_BUTTON_RIGHT, false);
    t.frames(2);
    const Camera after = t.camera();
    t.move_cursor(middle.x, middle.y);
    t.frames(3);
    CHECK(t.camera() == after);
}

TEST_CASE("flying: the wheel over the picture changes the field of view from 1 to 120 degrees") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        focus_picture(ctx);
        const Camera before = t.camera();
        ctx->MouseWheelY(1);
        ctx->Yield();
        CHECK(t.camera().vertical_fov < before.vertical_fov);
        CHECK(t.camera().look_from == before.look_from);
        for (int i = 0; i < 200; ++i)
            ctx->MouseWheelY(3);
        CHECK(t.camera().vertical_fov == doctest::Approx(1));
        for (int i = 0; i < 400; ++i)
            ctx->MouseWheelY(-3);
        CHECK(t.camera().vertical_fov == doctest::Approx(120));
        // Not while another panel is under the mouse.
        ctx->MouseMoveToPos(middle_of("Console"));
        ctx->MouseWheelY(5);
        CHECK(t.camera().vertical_fov == doctest::Approx(120));
    });
}

TEST_CASE("flying: with the right button held, the wheel sets the speed") {
    WindowTest t;
    t.frames(2);
    const double fov = t.camera().vertical_fov;
    const double speed = t.app->ui.viewport.fly_speed;
    const ImVec2 middle = middle_of("Viewport");
    t.move_cursor(middle.x, middle.y);
    t.frames(2);
    t.press_mouse(GLFW_MOUSE_BUTTON_RIGHT, true);
    t.frames(2);
    ImGui::GetIO().AddMouseWheelEvent(0, 3);
    t.frames(2);
    t.press_mouse(GLFW_MOUSE_BUTTON_RIGHT, false);
    t.frames(2);
    CHECK(t.app->ui.viewport.fly_speed > speed * 1.1);
    CHECK(t.camera().vertical_fov == fov);
}

TEST_CASE("picking: a click selects what is seen there; Shift adds; the sky selects nothing") {
    WindowTest t;
    t.frames_until([&] { return t.app->status.is_done; });
    t.run([&](ImGuiTestContext* ctx) {
        const Document& document = t.app->document;
        const ImRect rect = ImGui::FindWindowByName("Viewport")->InnerClipRect;
        // 1.2 to the side at a distance of 5, with 40 degrees over the height.
        const float side = 1.2f / (5 * std::tan(20 * 3.14159f / 180)) * rect.GetHeight() / 2;
        click_picture(t, ctx, {0, 0});
        CHECK(document.selection == std::vector<ObjectId>{{3}});
        click_picture(t, ctx, {side, 0});
        CHECK(document.selection == std::vector<ObjectId>{{4}});
        ctx->KeyDown(ImGuiMod_Shift);
        click_picture(t, ctx, {-side, 0});
        ctx->KeyUp(ImGuiMod_Shift);
        CHECK(document.selection == std::vector<ObjectId>{{4}, {2}});
        click_picture(t, ctx, {0, -rect.GetHeight() * 0.4f});
        CHECK(document.selection.empty());
        CHECK(t.app->document.history().size() == 1);
    });
}
