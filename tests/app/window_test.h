// What the window's tests are written with: the program as it is, opened anew for each test and
// driven frame by frame, with the Dear ImGui test engine for panels and GLFW's own callbacks for
// events of the system. Every frame is watched for OpenGL errors.
#pragma once

#include "actions.h"
#include "application.h"

#include <imgui.h>
#include <imgui_te_context.h>
#include <imgui_te_engine.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace tp::test {

struct WindowTestOptions {
    bool is_null_platform = true;
    std::string backend = "host";
    std::filesystem::path folder;       // temporary, for what tests write
    std::filesystem::path screenshots;  // empty: none
    int steps = 0;                      // of the random driver; 0 = its own number
    uint64_t seed = 0;
    // Of the pictures for the guide.
    int width = 1280, height = 720;  // of the window
    float scale = 1;                 // of the interface
    bool is_light = false;           // theme
    int samples = 4;                 // of a pixel
    std::filesystem::path model;     // empty: none
    std::string pictures;            // names, by commas; empty: all
};
WindowTestOptions& window_test_options();

/// Scenes that the repository ships, by name: "cornell_box".
std::filesystem::path shipped_scene(const std::string& name);

/// A small scene of a floor and three spheres (ids 1 to 4), one short sample.
Scene small_scene();
/// Writes it, or any other, into the temporary folder and returns the file.
std::filesystem::path write_scene(const Scene& scene, const std::string& name = "scene.json");

class WindowTest {
public:
    /// What the test before left, settings and recovery files, is there only where it is kept.
    enum class Folders { Emptied, Kept };
    explicit WindowTest(const Scene& scene = small_scene(), int width = 1280, int height = 720,
                        Folders folders = Folders::Emptied);
    ~WindowTest();
    WindowTest(const WindowTest&) = delete;
    WindowTest& operator=(const WindowTest&) = delete;

    /// Runs a test of the panels by the engine, which clicks and types; the calling thread draws
    /// frames meanwhile. What goes wrong in it fails the doctest case.
    void run(const std::function<void(ImGuiTestContext*)>& test);
    /// Calls a function between two frames on the thread that has GL; for use inside of `run`.
    void between_frames(ImGuiTestContext* ctx, const std::function<void()>& work);

    /// Ends the program; the seconds that this took.
    double close();

    /// Draws frames outside of `run`, with the events of the system.
    void frames(int count = 1);
    /// Draws frames until `done` holds; false if it does not within `seconds`.
    bool frames_until(const std::function<bool()>& done, double seconds = 60);
    /// The same inside of `run`.
    static bool yield_until(ImGuiTestContext* ctx, const std::function<bool()>& done,
                            double seconds = 60);

    /// Clicks the menu item of an action, in a submenu too.
    static void click_menu(ImGuiTestContext* ctx, const Action& action);

    /// Events of the system, as GLFW reports them.
    void move_cursor(double x, double y);
    void press_mouse(int button, bool down);
    void press_key(int key, bool down);
    void drop(const std::filesystem::path& file);
    void resize(int width, int height);
    GLFWwindow* glfw() const;

    /// Draws a frame with its pixels and returns them: RGB, top row first.
    std::vector<uint8_t> draw_and_read(int& width, int& height);
    /// Saves a picture of the window, if pictures are wanted.
    void screenshot(const std::string& name);
    /// Textures that OpenGL holds now.
    int live_textures() const;

    PanelContext context();
    const Scene& scene() const { return app->document.scene(); }
    Camera camera() const { return active_camera(app->document.scene()); }
    ImGuiTestEngineIO& engine_io() { return ImGuiTestEngine_GetIO(engine_); }

    std::unique_ptr<App> app;
    bool was_closed = false;  // the program would have ended
    int gl_errors = 0;        // since the start
    std::string gl_error_text;

private:
    void draw_one_frame();
    ImGuiTestEngine* engine_ = nullptr;
    std::function<void()> work_;
    int frame_count_ = 0;
};

}  // namespace tp::test
