// The window opens, shows the picture and closes.
#include "window_test.h"

#include <GLFW/glfw3.h>
#include <doctest/doctest.h>

using namespace tp;
using namespace tp::test;

TEST_CASE("start: the window shows the picture of the scene") {
    WindowTest t;
    CHECK(t.frames_until([&] {
        return t.app->status.is_done && t.app->texture.width() == t.app->ui.viewport.width;
    }));
    t.frames(2);
    CHECK(t.app->texture.width() == t.app->ui.viewport.width);
    CHECK(t.app->texture.height() == t.app->ui.viewport.height);
    CHECK(t.app->texture.width() > 500);
    t.screenshot("start");
}

TEST_CASE("start: closing ends the program, and asks where something is not saved") {
    WindowTest t;
    CHECK_FALSE(t.was_closed);
    t.app->document.edit("Change", "", [](Scene& s) { s.name = "Other"; });
    glfwSetWindowShouldClose(t.glfw(), GLFW_TRUE);
    t.frames(3);
    CHECK_FALSE(t.was_closed);
    t.run([&](ImGuiTestContext* ctx) {
        ctx->SetRef("Unsaved changes");
        ctx->ItemClick("Discard");
    });
    CHECK(t.was_closed);
}
