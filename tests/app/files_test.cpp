// Scene files through the window: dropped, opened by name, broken, saved.
#include "dialogs/dialogs.h"
#include "window_test.h"

#include <teapath/io/scene_file.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <string>

using namespace tp;
using namespace tp::test;

namespace {

std::filesystem::path write_text(const std::string& name, const std::string& text) {
    const std::filesystem::path file = window_test_options().folder / name;
    std::ofstream(file) << text;
    return file;
}

// Reading is a job: its end is a frame later.
void settle(WindowTest& t) {
    t.frames(1);
    CHECK(t.frames_until([&] { return t.app->ui.jobs.is_idle(); }));
    t.frames(2);
}

// A notice or a message says so.
bool has_error_toast(const WindowTest& t) {
    if (!t.app->ui.dialogs.messages.empty()) return !t.app->ui.dialogs.messages[0].text.empty();
    return std::any_of(t.app->ui.toasts.begin(), t.app->ui.toasts.end(),
                       [](const Toast& toast) { return toast.is_error && !toast.text.empty(); });
}

}  // namespace

TEST_CASE("files: a dropped scene is opened, and its picture comes") {
    WindowTest t;
    Scene other = small_scene();
    other.name = "Other";
    other.objects.edit().pop_back();
    const std::filesystem::path file = write_scene(other, "other.json");
    t.drop(file);
    settle(t);
    CHECK(t.scene() == load_scene(file));
    CHECK(t.app->document.file() == file);
    CHECK_FALSE(t.app->document.is_modified());
    CHECK(t.frames_until([&] { return t.app->status.is_done; }));
}

TEST_CASE(
    "files: a broken scene, dropped or opened by name, is a message and the old scene stays") {
    WindowTest t;
    const Scene before = t.scene();
    const std::filesystem::path old_file = t.app->document.file();
    const std::filesystem::path broken[] = {
        write_text("cut.json", R"({"version": 1, "objects": [)"),
        write_text("empty.json", ""),
        write_text("no_scene.json", R"([1, 2, 3])"),
        write_text("range.json", R"({"version": 1, "render": {"samples": -5}})"),
        write_text("picture.png", "no picture"),
        window_test_options().folder / "is_not_there.json",
        window_test_options().folder,
        write_text("percent %n%s%d.json", "%n%s%n"),
    };
    for (const std::filesystem::path& file : broken) {
        INFO(file.string());
        t.app->ui.toasts.clear();
        t.app->ui.dialogs.messages.clear();
        t.drop(file);
        settle(t);
        CHECK(has_error_toast(t));
        CHECK(t.scene() == before);
        CHECK(t.app->document.file() == old_file);
        t.app->ui.toasts.clear();
        t.app->ui.dialogs.messages.clear();
        PanelContext context = t.context();
        open_scene(context, file);
        settle(t);
        CHECK(has_error_toast(t));
        CHECK(t.scene() == before);
    }
    CHECK_FALSE(t.was_closed);
}

TEST_CASE("files: saved by Ctrl-S and read again, the scene is the same") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        Document& document = t.app->document;
        document.edit("Rename", "",
                      [](Scene& s) { s.objects.edit()[1].name = "a \"name\" \xc3\xa4 %s"; });
        document.edit("Move", "", [](Scene& s) {
            s.objects.edit()[1].transform.translation = {0.1, 1. / 3, 1e-7};
        });
        CHECK(document.is_modified());
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiKey_S);
        CHECK(WindowTest::yield_until(
            ctx, [&] { return !document.is_modified(); }, 5));
        CHECK(load_scene(document.file()) == document.scene());
        const Scene saved = document.scene();
        // Undo after saving is a change again, and redo none.
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiKey_Z);
        ctx->Yield();
        CHECK(document.is_modified());
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiKey_Y);
        ctx->Yield();
        CHECK_FALSE(document.is_modified());
        t.between_frames(ctx, [&] { document.open(document.file()); });
        CHECK(document.scene() == saved);
    });
}

TEST_CASE("files: every shipped scene opens and is drawn") {
    WindowTest t;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(shipped_scene("x").parent_path())) {
        if (entry.path().extension() != ".json" || entry.file_size() > 100000) continue;
        INFO(entry.path().string());
        t.drop(entry.path());
        settle(t);
        CHECK(t.app->document.file() == entry.path());
        CHECK_FALSE(has_error_toast(t));
    }
}
