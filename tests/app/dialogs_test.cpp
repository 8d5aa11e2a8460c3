// What asks and what runs beside the window: unsaved changes, the file browser, recovery, dropped
// images, exports, panels that close, layouts.
#include "dialogs/dialogs.h"

#include "jobs/autosave.h"
#include "panels/panels.h"
#include "window_test.h"

#include <teapath/editor/scene_edits.h>
#include <teapath/io/image_file.h>
#include <teapath/io/scene_file.h>

#include <GLFW/glfw3.h>
#include <doctest/doctest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <string>

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

bool is_idle(const WindowTest& t) {
    return t.app->ui.jobs.is_idle();
}

void open_scene_by(WindowTest& t, const fs::path& file) {
    PanelContext context = t.context();
    open_scene(context, file);
}

// The window's own browser, and a document that has no file.
void begin_new(WindowTest& t) {
    t.app->ui.preferences.native_dialogs = false;
    t.app->document.start_new();
    t.app->document.edit("Change", "", [](Scene& s) { s.name = "changed"; });
    t.frames(2);
}

void choose_in_browser(ImGuiTestContext* ctx, const char* title, const fs::path& file) {
    ctx->SetRef((std::string("//") + title + "###file browser").c_str());
    ctx->ItemInput("##name");
    ctx->KeyCharsReplace(file.c_str());
    ctx->ItemClick("###accept");
    ctx->Yield(2);
}

fs::path write_ppm(const std::string& name) {
    const fs::path file = window_test_options().folder / name;
    std::ofstream(file) << "P6 2 1 255\nabcdef";
    return file;
}

// A program that autosaved and was killed.
void leave_behind(const std::string& scene_name, const fs::path& original) {
    const pid_t child = fork();
    if (child == 0) {
        AutosaveFile file(state_folder() / "autosave");
        Scene scene = small_scene();
        scene.name = scene_name;
        file.write(scene, original, file.ticket());
        kill(getpid(), SIGKILL);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
}

}  // namespace

TEST_CASE("dialogs: quitting with a scene that has no file: Save asks for one, then ends") {
    WindowTest t;
    begin_new(t);
    const fs::path file = window_test_options().folder / "quit.json";
    fs::remove(file);
    glfwSetWindowShouldClose(t.glfw(), GLFW_TRUE);
    t.frames(3);
    t.run([&](ImGuiTestContext* ctx) {
        ctx->SetRef("Unsaved changes");
        ctx->ItemClick("Save");
        ctx->Yield(3);
        CHECK_FALSE(t.was_closed);
        choose_in_browser(ctx, "Save the scene as", file);
        CHECK(WindowTest::yield_until(ctx, [&] { return t.app->ui.dialogs.quits; }));
    });
    CHECK(load_scene(file).name == "changed");
}

TEST_CASE("dialogs: Cancel keeps everything, Discard goes on") {
    WindowTest t;
    begin_new(t);
    t.run([&](ImGuiTestContext* ctx) {
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiKey_N);
        ctx->Yield(3);
        ctx->SetRef("Unsaved changes");
        ctx->ItemClick("Cancel");
        ctx->Yield(2);
        CHECK(t.scene().name == "changed");
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiKey_N);
        ctx->Yield(3);
        ctx->SetRef("Unsaved changes");
        ctx->ItemClick("Discard");
        ctx->Yield(2);
        CHECK(t.scene().name != "changed");
        CHECK_FALSE(t.app->document.is_modified());
    });
}

TEST_CASE(
    "dialogs: the browser opens a file, asks before it replaces one, and remembers its folder") {
    WindowTest t;
    t.app->ui.preferences.native_dialogs = false;
    const fs::path folder = window_test_options().folder / "browsed";
    fs::create_directories(folder);
    Scene other = small_scene();
    other.name = "browsed";
    save_scene(other, folder / "other.json");
    t.run([&](ImGuiTestContext* ctx) {
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiKey_O);
        ctx->Yield(3);
        choose_in_browser(ctx, "Open a scene or a model", folder);  // goes into it
        choose_in_browser(ctx, "Open a scene or a model", "other.json");
        CHECK(WindowTest::yield_until(ctx, [&] { return t.scene().name == "browsed"; }));
        CHECK(t.app->ui.preferences.folders["scene"] == folder.string());
        CHECK(t.app->ui.preferences.recent_files.front() == (folder / "other.json").string());

        // Over a file that is there: once for the question, once to answer it.
        t.app->document.edit("Name", "", [](Scene& s) { s.name = "replaced"; });
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiMod_Shift | ImGuiKey_S);
        ctx->Yield(3);
        choose_in_browser(ctx, "Save the scene as", "other.json");
        CHECK(load_scene(folder / "other.json").name == "browsed");
        ctx->ItemClick("###accept");
        CHECK(WindowTest::yield_until(ctx, [&] { return !t.app->document.is_modified(); }));
        CHECK(load_scene(folder / "other.json").name == "replaced");
    });
    // A window that starts later begins in the same folder.
    CHECK(t.app->ui.preferences.folders["scene"] == folder.string());
}

TEST_CASE("dialogs: work of a killed program is offered; recovered, it is unsaved under its name") {
    const fs::path original = write_scene(small_scene(), "mine.json");
    const std::string before = scene_text(load_scene(original));
    leave_behind("lost and found", original);
    {
        WindowTest t(small_scene(), 1280, 720, WindowTest::Folders::Kept);
        REQUIRE(t.app->ui.autosave.leftovers.size() == 1);
        t.screenshot("recovery");
        t.run([&](ImGuiTestContext* ctx) {
            ctx->ItemClick("//Recover unsaved work/**/Recover");
            CHECK(WindowTest::yield_until(ctx, [&] { return t.scene().name == "lost and found"; }));
        });
        CHECK(t.app->document.file() == original);
        CHECK(t.app->document.is_modified());
        CHECK(scene_text(load_scene(original)) == before);
        // Kept in a file of this window's own, then the crashed one's goes.
        CHECK(t.frames_until([&] { return is_idle(t); }));
        t.frames(3);
        CHECK(find_leftovers(state_folder() / "autosave").empty());
    }
    // A clean end leaves nothing.
    CHECK(fs::is_empty(state_folder() / "autosave"));
    WindowTest next(small_scene(), 1280, 720, WindowTest::Folders::Kept);
    CHECK(next.app->ui.autosave.leftovers.empty());
}

TEST_CASE("dialogs: a texture's image is asked for like any other file") {
    WindowTest t;
    t.app->ui.preferences.native_dialogs = false;
    const fs::path image = write_ppm("dots.ppm");
    t.app->document.edit("Texture", "", [](Scene& s) { add_texture(s, TextureKind::Image); });
    t.app->document.select(item_of(t.scene().textures[0].id));
    t.run([&](ImGuiTestContext* ctx) {
        ctx->Yield(2);
        ctx->ItemClick("//Inspector/**/Open\xe2\x80\xa6");
        ctx->Yield(2);
        choose_in_browser(ctx, "Open an image", image);
        CHECK(t.yield_until(ctx, [&] { return t.scene().textures[0].file.image != nullptr; }));
    });
    CHECK(t.scene().textures[0].file.path == "dots.ppm");  // beside the scene
    t.app->document.undo();
    CHECK(!t.scene().textures[0].file.image);
}

TEST_CASE("dialogs: dropped images become the background or the selection's colour") {
    WindowTest t;
    const fs::path image = write_ppm("dots.ppm");
    t.move_cursor(640, 300);
    t.frames(2);
    t.drop(image);
    CHECK(t.frames_until([&] { return t.scene().background.kind == BackgroundKind::Image; }));
    CHECK(t.scene().background.file.image);
    t.app->document.select(ObjectId{2});
    t.drop(image);
    CHECK(t.frames_until([&] { return !t.scene().textures.empty(); }));
    CHECK(t.scene().materials[1].color.texture == t.scene().textures[0].id);
    CHECK(t.app->document.history().back().label == "Colour image");
    t.app->ui.toasts.clear();
    t.drop(window_test_options().folder / "letter.docx");
    t.frames(2);
    CHECK(t.app->ui.toasts.size() == 1);
    CHECK(t.app->ui.toasts.front().is_error);
}

TEST_CASE("dialogs: a dropped mesh becomes an object in view; a broken one is a message") {
    WindowTest t;
    const fs::path file = window_test_options().folder / "roof.ply";
    std::ofstream(file) << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                           "property float y\nproperty float z\nelement face 2\n"
                           "property list uchar int vertex_index\nend_header\n"
                           "0 0 0\n1 0 0\n0.5 1 0\n0.5 0 1\n3 0 1 2\n3 1 3 2\n";
    const size_t before = t.scene().objects.size();
    t.drop(file);
    CHECK(t.frames_until([&] { return t.scene().objects.size() == before + 1; }));
    const Object& object = t.scene().objects.back();
    CHECK(object.name == "roof");
    REQUIRE(std::holds_alternative<MeshShape>(object.shape));
    CHECK(std::get<MeshShape>(object.shape).file.mesh->triangles.size() == 2);
    CHECK(t.app->document.is_selected(item_of(object.id)));
    t.app->document.undo();
    CHECK(t.scene().objects.size() == before);

    std::ofstream(file) << "ply\n";
    t.app->ui.toasts.clear();
    t.drop(file);
    CHECK(t.frames_until(
        [&] { return !t.app->ui.dialogs.messages.empty() || !t.app->ui.toasts.empty(); }));
    CHECK(t.scene().objects.size() == before);
}

// Two triangles of two materials, in the folder of the tests.
fs::path write_obj() {
    const fs::path folder = window_test_options().folder;
    std::ofstream(folder / "tent.mtl") << "newmtl red\nKd 0.8 0.1 0.1\nnewmtl blue\nKd 0 0 1\n";
    std::ofstream(folder / "tent.obj") << "mtllib tent.mtl\nv 0 0 0\nv 1 0 0\nv 0.5 1 0\n"
                                          "v 0.5 0 1\nusemtl red\nf 1 2 3\nusemtl blue\n"
                                          "f 2 4 3\n";
    return folder / "tent.obj";
}

TEST_CASE("dialogs: a dropped model stands in view with its materials, and is placed as a whole") {
    WindowTest t;
    const size_t before = t.scene().objects.size(), materials = t.scene().materials.size();
    t.drop(write_obj());
    CHECK(t.frames_until([&] { return t.scene().models.size() == 1; }));
    CHECK(t.scene().objects.size() == before + 2);
    CHECK(t.scene().materials.size() == materials + 2);
    const ModelId id = t.scene().models[0].id;
    CHECK(t.app->document.is_selected(item_of(id)));
    CHECK(t.scene().models[0].name == "tent");

    // The inspector moves the whole.
    const Double3 was = t.scene().objects.back().transform.translation;
    t.run([&](ImGuiTestContext* ctx) {
        ctx->SetRef("//Inspector");
        ctx->ItemInputValue("**/##Positionx", 7.5f);
        ctx->Yield(2);
    });
    CHECK(t.scene().models[0].transform.translation.x == 7.5);
    CHECK(t.scene().objects.back().transform.translation.x != was.x);

    // Saved and read again, it is the same scene.
    const fs::path file = window_test_options().folder / "with_model.json";
    save_scene(t.scene(), file);
    const Scene again = load_scene(file);
    CHECK(again.models.size() == 1);
    CHECK(again.objects.size() == before + 2);
    CHECK(scene_text(again).find("objects\": {") == std::string::npos);  // nothing is changed

    t.run([&](ImGuiTestContext* ctx) {
        ctx->SetRef("//Inspector");
        ctx->ItemClick("**/Select its objects");
        ctx->Yield(2);
    });
    CHECK(t.app->document.selection.size() == 2);
    t.app->document.select(item_of(id));
    t.run([&](ImGuiTestContext* ctx) { ctx->KeyPress(ImGuiKey_Delete); });
    CHECK(t.scene().models.empty());
    CHECK(t.scene().objects.size() == before);
    CHECK(t.scene().materials.size() == materials);
    t.app->document.undo();
    CHECK(t.scene().objects.size() == before + 2);
}

TEST_CASE("dialogs: a model opened as a scene is seen whole, and has no file yet") {
    WindowTest t;
    open_scene_by(t, write_obj());
    CHECK(t.frames_until([&] { return t.scene().models.size() == 1; }));
    CHECK(t.app->document.file().empty());
    CHECK(t.scene().name == "tent");
    CHECK_FALSE(t.app->document.is_modified());
}

TEST_CASE("dialogs: an export runs beside the window and says where its file is") {
    WindowTest t;
    const fs::path file = window_test_options().folder / "exported.png";
    fs::remove(file);
    t.run([&](ImGuiTestContext* ctx) {
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiMod_Shift | ImGuiKey_E);
        ctx->Yield(3);
        t.app->ui.dialogs.exports.file = file;
        t.app->ui.dialogs.exports.backend = BackendKind::Host;
        ctx->Yield(2);
        ctx->ItemClick("//Export/Export");
        CHECK(WindowTest::yield_until(ctx, [&] { return is_idle(t) && fs::exists(file); }));
    });
    CHECK(read_image(file).width == t.scene().render.width);
}

TEST_CASE("dialogs: the picture and the window are saved as images") {
    WindowTest t;
    const fs::path picture = window_test_options().folder / "picture.exr";
    const fs::path window = window_test_options().folder / "window.png";
    t.app->ui.preferences.native_dialogs = false;
    t.run([&](ImGuiTestContext* ctx) {
        ctx->KeyPress(ImGuiMod_Ctrl | ImGuiKey_E);
        ctx->Yield(3);
        choose_in_browser(ctx, "Save the image as", picture);
        CHECK(WindowTest::yield_until(ctx, [&] { return is_idle(t) && fs::exists(picture); }));
    });
    PanelContext context = t.context();
    ask_to_save_window(context);
    t.frames(2);
    t.run([&](ImGuiTestContext* ctx) {
        choose_in_browser(ctx, "Save a picture of the window as", window);
        CHECK(WindowTest::yield_until(ctx, [&] { return is_idle(t) && fs::exists(window); }));
    });
    CHECK(read_image(picture).width == t.app->ui.viewport.width);
    CHECK(read_image(window).width == 1280);
}

TEST_CASE(
    "layouts: every panel closes and comes back; built-in layouts; one saved and taken again") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        for (const Panel& panel : panels()) {
            INFO(std::string(panel.title));
            t.app->ui.preferences.set_panel_open(panel.title, false);
            ctx->Yield(2);
            const ImGuiWindow* window = ImGui::FindWindowByName(panel.title);
            CHECK((!window || !window->WasActive));
            t.app->ui.preferences.set_panel_open(panel.title, true);
            ctx->Yield(3);
            window = ImGui::FindWindowByName(panel.title);
            CHECK((window && window->WasActive));
        }
        for (const char* name : {"Render", "Inspect", "Edit"}) {
            t.app->ui.layout.built_in = name;
            ctx->Yield(8);
            t.between_frames(ctx, [&] { t.screenshot(std::string("layout_") + name); });
            const bool is_alone = std::string(name) == "Render";
            CHECK(t.app->ui.preferences.is_panel_open("Options") != is_alone);
            CHECK(t.app->ui.preferences.is_panel_open("Viewport"));
        }
        // Saved by its window, then another one, then back.
        t.app->ui.preferences.set_panel_open("Console", false);
        ctx->Yield(2);
        t.app->ui.dialogs.show_save_layout = true;
        t.app->ui.dialogs.layout_name = "mine";
        ctx->Yield(3);
        ctx->ItemClick("//Save the layout/Save");
        ctx->Yield(2);
        t.app->ui.reset_layout = true;
        ctx->Yield(6);
        CHECK(t.app->ui.preferences.is_panel_open("Console"));
        ctx->SetRef("##MainMenuBar");
        ctx->MenuClick("View/Layouts/mine##saved");
        ctx->Yield(6);
        CHECK_FALSE(t.app->ui.preferences.is_panel_open("Console"));
        CHECK(t.app->ui.viewport.width > 400);
    });
}
