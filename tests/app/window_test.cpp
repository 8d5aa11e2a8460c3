#include "window_test.h"

// The GL loader goes before GLFW.
// clang-format off
#include <glad/gl.h>
#include <GLFW/glfw3.h>
// clang-format on

#include <teapath/io/image_file.h>
#include <teapath/io/scene_file.h>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <chrono>
#include <exception>

namespace tp::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr float kFrameSeconds = 1.0f / 60;

// Counts what OpenGL calls an error; notices and hints on speed are not.
void APIENTRY on_gl_message(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text,
                            const void* user) {
    if (type != GL_DEBUG_TYPE_ERROR) return;
    auto* test = const_cast<WindowTest*>(static_cast<const WindowTest*>(user));
    ++test->gl_errors;
    test->gl_error_text = text;
}

// The callback that GLFW has for an event, without changing it.
template <class Callback>
Callback installed(Callback (*set)(GLFWwindow*, Callback), GLFWwindow* window) {
    const Callback callback = set(window, nullptr);
    set(window, callback);
    return callback;
}

Object sphere(uint32_t id, const std::string& name, const Double3& center, double radius) {
    Object object;
    object.id = {id};
    object.name = name;
    object.shape = SphereShape{center, radius};
    object.material = {id};
    return object;
}

}  // namespace

WindowTestOptions& window_test_options() {
    static WindowTestOptions options;
    return options;
}

std::filesystem::path shipped_scene(const std::string& name) {
    return std::filesystem::path(TEAPATH_SOURCE_DIR) / "scenes" / (name + ".json");
}

Scene small_scene() {
    Scene scene;
    scene.name = "Small";
    Camera camera;
    camera.id = {1};
    camera.look_from = {0, 1, 5};
    camera.look_at = {0, 0.5, 0};
    scene.cameras = {camera};
    const MaterialKind kinds[] = {MaterialKind::Lambertian, MaterialKind::Lambertian,
                                  MaterialKind::Metal, MaterialKind::Dielectric};
    const char* names[] = {"floor", "matt", "metal", "glass"};
    for (uint32_t i = 0; i < 4; ++i) {
        Material material;
        material.id = {i + 1};
        material.name = names[i];
        material.kind = kinds[i];
        material.color.color = i == 3 ? Double3(1) : Double3(0.6, 0.5, 0.4);
        scene.materials.edit().push_back(material);
    }
    Object floor;
    floor.id = {1};
    floor.name = "floor";
    floor.shape = XzRectShape{{-10, -10}, {10, 10}, 0};
    floor.material = {1};
    scene.objects = {floor, sphere(2, "matt ball", {-1.2, 0.5, 0}, 0.5),
                     sphere(3, "metal ball", {0, 0.5, 0}, 0.5),
                     sphere(4, "glass ball", {1.2, 0.5, 0}, 0.5)};
    scene.render.samples = 1;  // the processor is for the interface
    scene.render.path.max_depth = 3;
    scene.render.width = 64;
    scene.render.height = 36;
    return scene;
}

std::filesystem::path write_scene(const Scene& scene, const std::string& name) {
    const std::filesystem::path file = window_test_options().folder / name;
    save_scene(scene, file);
    return file;
}

WindowTest::WindowTest(const Scene& scene, int width, int height, Folders folders) {
    if (folders == Folders::Emptied) {
        for (const auto& entry : std::filesystem::directory_iterator(window_test_options().folder))
            std::filesystem::remove_all(entry.path());
    }
    // A debug context reports every error by itself.
    glfwInit();
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
    AppOptions options;
    options.scene = write_scene(scene);
    options.backend = window_test_options().backend;
    options.threads = 1;
    options.width = width;
    options.height = height;
    app = std::make_unique<App>(options);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_gl_message, this);
    glfwSwapInterval(0);

    engine_ = ImGuiTestEngine_CreateContext();
    ImGuiTestEngineIO& io = engine_io();
    io.ConfigSavedSettings = false;
    io.ConfigCaptureEnabled = false;
    io.ConfigMouseDrawCursor = false;
    io.ConfigFixedDeltaTime = kFrameSeconds;
    io.ConfigNoThrottle = true;
    io.ConfigWatchdogWarning = io.ConfigWatchdogKillTest = 1e6f;
    ImGuiTestEngine_Start(engine_, ImGui::GetCurrentContext());
    installed(glfwSetCursorEnterCallback, glfw())(glfw(), GLFW_TRUE);
    frames(4);
}

WindowTest::~WindowTest() {
    close();
    CHECK_MESSAGE(gl_errors == 0, std::string(gl_error_text));
}

double WindowTest::close() {
    if (!app) return 0;
    ImGuiTestEngine_Stop(engine_);
    const auto start = Clock::now();
    app.reset();
    const std::chrono::duration<double> seconds = Clock::now() - start;
    ImGuiTestEngine_DestroyContext(engine_);
    return seconds.count();
}

void WindowTest::draw_one_frame() {
    // Software GL spends nine tenths of a frame on pixels that no test looks at. Without them every
    // call of OpenGL is made and checked all the same.
    const bool with_pixels = ++frame_count_ % 64 == 0;
    (with_pixels ? glDisable : glEnable)(GL_RASTERIZER_DISCARD);
    app->draw_frame(0);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        ++gl_errors;
        gl_error_text = "glGetError after a frame: " + std::to_string(error);
    }
    app->window.show();
    ImGuiTestEngine_PostSwap(engine_);
    was_closed = was_closed || app->is_closed();
    if (work_) std::exchange(work_, nullptr)();
}

void WindowTest::run(const std::function<void(ImGuiTestContext*)>& test) {
    ImGuiTest* registered = ImGuiTestEngine_RegisterTest(engine_, "window", "case");
    std::exception_ptr escaped;  // a REQUIRE that does not hold, for doctest on this thread
    registered->TestFunc = [&](ImGuiTestContext* ctx) {
        try {
            test(ctx);
        } catch (...) {
            escaped = std::current_exception();
        }
    };
    ImGuiTestEngine_QueueTest(engine_, registered);
    do
        draw_one_frame();
    while (!ImGuiTestEngine_IsTestQueueEmpty(engine_));
    const bool passed = registered->Output.Status == ImGuiTestStatus_Success;
    ImGuiTextBuffer log;
    registered->Output.Log.ExtractLinesForVerboseLevels(ImGuiTestVerboseLevel_Error,
                                                        ImGuiTestVerboseLevel_Warning, &log);
    CHECK_MESSAGE(passed, std::string(log.c_str()));
    ImGuiTestEngine_UnregisterTest(engine_, registered);
    if (escaped) std::rethrow_exception(escaped);
}

void WindowTest::between_frames(ImGuiTestContext* ctx, const std::function<void()>& work) {
    work_ = work;
    while (work_)
        ctx->Yield();
}

void WindowTest::frames(int count) {
    for (int i = 0; i < count; ++i)
        draw_one_frame();
}

bool WindowTest::frames_until(const std::function<bool()>& done, double seconds) {
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (!done()) {
        if (Clock::now() > end) return false;
        draw_one_frame();
    }
    return true;
}

bool WindowTest::yield_until(ImGuiTestContext* ctx, const std::function<bool()>& done,
                             double seconds) {
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (!done()) {
        if (Clock::now() > end || ctx->IsError()) return false;
        ctx->Yield();
    }
    return true;
}

void WindowTest::click_menu(ImGuiTestContext* ctx, const Action& action) {
    ctx->SetRef("##MainMenuBar");
    ctx->MenuClick(fmt::format("{}/###{}", action.menu, action.id).c_str());
}

GLFWwindow* WindowTest::glfw() const {
    return glfwGetCurrentContext();
}

void WindowTest::move_cursor(double x, double y) {
    installed(glfwSetCursorPosCallback, glfw())(glfw(), x, y);
}

void WindowTest::press_mouse(int button, bool down) {
    installed(glfwSetMouseButtonCallback, glfw())(glfw(), button, down ? GLFW_PRESS : GLFW_RELEASE,
                                                  0);
}

void WindowTest::press_key(int key, bool down) {
    installed(glfwSetKeyCallback, glfw())(glfw(), key, glfwGetKeyScancode(key),
                                          down ? GLFW_PRESS : GLFW_RELEASE, 0);
}

void WindowTest::drop(const std::filesystem::path& file) {
    const std::string name = file.string();
    const char* names[] = {name.c_str()};
    installed(glfwSetDropCallback, glfw())(glfw(), 1, names);
}

void WindowTest::resize(int width, int height) {
    glfwSetWindowSize(glfw(), width, height);
}

std::vector<uint8_t> WindowTest::draw_and_read(int& width, int& height) {
    glDisable(GL_RASTERIZER_DISCARD);
    app->draw_frame(0);
    std::vector<uint8_t> pixels = app->window.read_pixels(width, height);
    app->window.show();
    ImGuiTestEngine_PostSwap(engine_);
    return pixels;
}

void WindowTest::screenshot(const std::string& name) {
    if (window_test_options().screenshots.empty()) return;
    Picture picture;
    picture.display = draw_and_read(picture.width, picture.height);
    write_picture(window_test_options().screenshots / (name + ".png"), picture);
}

int WindowTest::live_textures() const {
    int count = 0;
    for (GLuint name = 1; name < 4096; ++name)
        count += glIsTexture(name);
    return count;
}

PanelContext WindowTest::context() {
    return {app->document, app->worker, app->ui,    app->texture,
            app->layers,   app->window, app->status};
}

}  // namespace tp::test
