// The window's size, its panels' places, and what they cost in OpenGL.
#include "window_test.h"

#include <GLFW/glfw3.h>
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>

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

}  // namespace

TEST_CASE("layout: a thousand sizes, from nothing to large and odd, make no error and no texture") {
    WindowTest t;
    t.frames_until([&] { return t.app->status.is_done; });
    std::mt19937 random(7);
    const auto pick = [&](int low, int high) {
        return std::uniform_int_distribution(low, high)(random);
    };
    const int textures = t.live_textures();
    for (int i = 0; i < 1000; ++i) {
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
    CHECK(t.frames_until([&] {
        return t.app->status.is_done && t.app->texture.width() == t.app->ui.viewport.width;
    }));
    CHECK(t.live_textures() == textures);
    CHECK(t.app->ui.viewport.width > 500);
}

TEST_CASE("layout: iconified and restored a hundred times, the picture is back in the next frame") {
    WindowTest t;
    t.frames_until([&] { return t.app->status.is_done; });
    t.frames(2);
    const int textures = t.live_textures();
    const int width = t.app->texture.width(), height = t.app->texture.height();
    const uint64_t id = t.app->texture.id();
    for (int i = 0; i < 100; ++i) {
        glfwIconifyWindow(t.glfw());
        t.frames(2);
        REQUIRE(t.app->texture.width() == width);
        glfwRestoreWindow(t.glfw());
        t.frames(1);
        REQUIRE(t.app->texture.width() == width);
        REQUIRE(t.app->texture.height() == height);
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
        ctx->SetRef("##MainMenuBar");
        ctx->ItemClick("##MenuBar/View");
        ctx->ItemClick("//###Menu_00/###view.reset_layout");
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
        INFO(width, " x ", height);
        CHECK(t.app->ui.viewport.width >= share * width);
        for (const char* name :
             {"Viewport", "Options", "Scene", "Inspector", "Console", "Metrics"}) {
            const Place place = place_of(name);
            CHECK(place.position.x >= 0);
            CHECK(place.position.y >= 0);
            CHECK(place.position.x + place.size.x <= static_cast<float>(width) + 1);
            CHECK(place.position.y + place.size.y <= static_cast<float>(height) + 1);
        }
        t.screenshot("layout_" + std::to_string(width));
    }
}
