// The window opens, shows the picture and closes.
#include "window_test.h"

#include <GLFW/glfw3.h>
#include <doctest/doctest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

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

TEST_CASE("start: a scene that cannot be read is a message beside a new scene") {
    const std::filesystem::path broken = window_test_options().folder / "broken.json";
    std::ofstream(broken) << R"({"teapath": 1, "objects": [)";
    for (const std::filesystem::path& file : {broken, broken.parent_path() / "missing.json"}) {
        AppOptions options;
        options.scene = file;
        options.backend = "host";
        options.threads = 1;
        App app(options);
        app.draw_frame(0);
        app.draw_frame(0);
        const Document fresh;
        CHECK(app.document.scene() == fresh.scene());
        CHECK(app.document.file().empty());
        CHECK_FALSE(app.document.is_modified());
        const std::string title = file.filename().string() + " cannot be opened";
        const ImGuiWindow* message = ImGui::FindWindowByName((title + "###message").c_str());
        REQUIRE(message);
        CHECK(message->Active);
        const std::vector<LogLine> log = log_lines_after(0);
        CHECK(std::any_of(log.begin(), log.end(), [&](const LogLine& line) {
            return line.level == LogLevel::Error && line.text.find(title + ": ") == 0;
        }));
        for (const std::string& recent : app.ui.preferences.recent_files)
            CHECK(recent != file.string());
        std::ifstream log_file(state_folder() / "teapath.log");
        const std::string written((std::istreambuf_iterator<char>(log_file)), {});
        CHECK(written.find("error: " + title + ": ") != std::string::npos);
    }
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
