// The window's size, its panels' places, and what they cost in OpenGL.
#include "window_test.h"

#include <GLFW/glfw3.h>
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace tp;
using namespace tp::test;

namespace {

struct Place {
    ImVec2 position, size;
    ImGuiID dock = 0;
};

Place place_of(const char* window) {
    const ImGuiWindow* w = ImGui::FindWindowByName(window);
    return w ? Place{w->Pos, w->Size, w->DockId} : Place{};
}

bool is_near(const Place& a, const Place& b) {
    return std::abs(a.position.x - b.position.x) < 3 && std::abs(a.position.y - b.position.y) < 3 &&
           std::abs(a.size.x - b.size.x) < 3 && std::abs(a.size.y - b.size.y) < 3;
}

// Draws a frame and returns the middle of the picture as it is on the screen.
std::vector<uint8_t> picture_on_screen(WindowTest& t) {
    const ImRect rect = ImGui::FindWindowByName("Viewport")->InnerClipRect;
    int width = 0, height = 0;
    const std::vector<uint8_t> pixels = t.draw_and_read(width, height);
    std::vector<uint8_t> middle;
    for (int y = static_cast<int>(rect.Min.y) + 60; y < static_cast<int>(rect.Max.y) - 60; y += 3)
        for (int x = static_cast<int>(rect.Min.x) + 20; x < static_cast<int>(rect.Max.x) - 20;
             x += 3)
            middle.push_back(pixels[3 * static_cast<size_t>(y * width + x)]);
    return middle;
}

}  // namespace

TEST_CASE("layout: a thousand sizes, from nothing to large and odd, make no error and no texture") {
    WindowTest t;
    t.frames_until([&] { return t.app->status.is_done; });
    std::mt19937 random(7);
    const auto pick = [&](int low, int high) {
        return std::uniform_int_distribution(low, high)(random);
    };
    const int textures = t.live_textures();
    // A window manager takes its time for each.
    const int sizes = window_test_options().is_null_platform ? 1000 : 200;
    for (int i = 0; i < sizes; ++i) {
        int width = pick(1, 1600), height = pick(1, 1000);
        if (i % 25 == 0) width = height = 1;
        if (i % 25 == 5) width = height = 0;
        if (i % 25 == 10) height = 1;
        if (i % 25 == 15) width = 2 * pick(50, 400) + 1, height = 2 * pick(50, 400) + 1;
        t.resize(width, height);
        t.frames(1);
        REQUIRE(t.gl_errors == 0);
    }
    t.resize(1280, 720);
    t.frames(2);
    // A window manager takes its time.
    CHECK(t.frames_until([&] { return t.app->ui.viewport.width > 500; }));
    CHECK(t.frames_until([&] {
        return t.app->status.is_done && t.app->texture.width() == t.app->ui.viewport.width;
    }));
    // The picture keeps the textures of its last sizes, and materials have theirs; no more.
    const auto previews = static_cast<int>(t.app->previews.rendered());
    CHECK(t.live_textures() <= textures + static_cast<int>(DisplayTexture::kSlots) - 1 + previews);
}

TEST_CASE("layout: minimised and restored a hundred times, the picture is back in the next frame") {
    WindowTest t;
    t.frames_until([&] {
        return t.app->status.is_done && t.app->texture.width() == t.app->ui.viewport.width;
    });
    t.app->ui.toasts.clear();
    t.frames(2);
    const int textures = t.live_textures();
    const uint64_t id = t.app->texture.id();
    const auto is_minimised = [&] { return glfwGetWindowAttrib(t.glfw(), GLFW_ICONIFIED) != 0; };
    const std::vector<uint8_t> before = picture_on_screen(t);
    for (int i = 0; i < 100; ++i) {
        glfwIconifyWindow(t.glfw());
        if (!t.frames_until(is_minimised, 3)) {
            MESSAGE("no window manager here: nothing was minimised");
            return;
        }
        t.frames(2);
        glfwRestoreWindow(t.glfw());
        REQUIRE(t.frames_until([&] { return !is_minimised(); }, 10));
        REQUIRE(picture_on_screen(t) == before);  // draws one frame
        REQUIRE(t.gl_errors == 0);
    }
    CHECK(t.app->texture.id() == id);  // nothing was made anew
    CHECK(t.live_textures() == textures);
}

TEST_CASE("layout: panels can be moved out and docked elsewhere, and a reset puts them back") {
    WindowTest t;
    const char* panels[] = {"Viewport", "Options", "Scene", "Inspector", "Console"};
    t.run([&](ImGuiTestContext* ctx) {
        Place before[5];
        for (int i = 0; i < 5; ++i)
            before[i] = place_of(panels[i]);
        ctx->UndockWindow("Options");
        ctx->Yield(2);
        CHECK(place_of("Options").dock == 0);
        ctx->WindowMove("//Options", {300, 200});
        ctx->WindowResize("//Options", {240, 300});
        ctx->DockInto("Inspector", "Console", ImGuiDir_Right);
        ctx->Yield(2);
        CHECK_FALSE(is_near(place_of("Inspector"), before[3]));
        t.click_menu(ctx, action("view.reset_layout"));
        ctx->Yield(4);
        for (int i = 0; i < 5; ++i) {
            INFO(std::string(panels[i]));
            CHECK(is_near(place_of(panels[i]), before[i]));
        }
    });
}

TEST_CASE("layout: the picture has most of the width, and nothing lies outside of the window") {
    for (const auto& [width, height, share] :
         {std::tuple{1280, 720, 0.55}, {1920, 1080, 0.6}, {3840, 2160, 0.7}}) {
        WindowTest t(small_scene(), width, height);
        t.frames(4);
        const ImVec2 size =
            ImGui::GetMainViewport()->Size;  // a screen may be too small for all of it
        INFO(size.x, " x ", size.y);
        if (size.x >= static_cast<float>(width)) CHECK(t.app->ui.viewport.width >= share * width);
        for (const char* name :
             {"Viewport", "Options", "Scene", "Inspector", "Console", "Metrics"}) {
            const Place place = place_of(name);
            CHECK(place.position.x >= 0);
            CHECK(place.position.y >= 0);
            CHECK(place.position.x + place.size.x <= size.x + 1);
            CHECK(place.position.y + place.size.y <= size.y + 1);
        }
        t.screenshot("layout_" + std::to_string(width));
    }
}
