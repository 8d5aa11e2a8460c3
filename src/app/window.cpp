#include "window.h"

// The GL loader goes before GLFW.
// clang-format off
#include <glad/gl.h>
#include <GLFW/glfw3.h>
// clang-format on

#include "theme.h"
#include "window_icon.h"

#include <teapath/app/app.h>
#include <teapath/core/error.h>

#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>
#include <implot.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace tp {
namespace {

std::string& last_glfw_error() {
    static std::string text;
    return text;
}

void set_icon(GLFWwindow* window) {
    if (glfwGetPlatform() != GLFW_PLATFORM_X11) return;  // others take it from the desktop's files
    std::vector<std::vector<uint8_t>> pixels;
    std::vector<GLFWimage> images;
    for (const int size : {16, 32, 48, 64, 128}) {
        pixels.push_back(window_icon(size));
        images.push_back({size, size, pixels.back().data()});
    }
    glfwSetWindowIcon(window, static_cast<int>(images.size()), images.data());
}

// Pixels of the window that a monitor shows.
int64_t shown_pixels(GLFWmonitor* monitor, const WindowPlace& place) {
    int x = 0, y = 0;
    glfwGetMonitorPos(monitor, &x, &y);
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    if (!mode) return 0;
    const int width = std::min(place.x + place.width, x + mode->width) - std::max(place.x, x);
    const int height = std::min(place.y + place.height, y + mode->height) - std::max(place.y, y);
    return width > 0 && height > 0 ? int64_t{width} * height : 0;
}

// The monitor that shows most of a place, and how much; null where none shows any.
std::pair<GLFWmonitor*, int64_t> monitor_of(const WindowPlace& place) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    std::pair<GLFWmonitor*, int64_t> best{nullptr, 0};
    for (int i = 0; i < count; ++i)
        if (const int64_t pixels = shown_pixels(monitors[i], place); pixels > best.second)
            best = {monitors[i], pixels};
    return best;
}

}  // namespace

bool has_display() {
    const auto is_set = [](const char* name) {
        const char* value = std::getenv(name);
        return value && *value;
    };
    return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

Window::Window(int width, int height, const std::string& title) {
    glfwSetErrorCallback([](int, const char* text) { last_glfw_error() = text; });
    if (!glfwInit())
        throw Error(ErrorKind::Device, "no window can be opened: " + last_glfw_error(), "",
                    "start it on a desktop, or use `teapath render`");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    if (glfwGetPlatform() == GLFW_PLATFORM_NULL)  // the tests, where there is no display
        glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (!window_) {
        const std::string why = last_glfw_error();
        glfwTerminate();
        throw Error(
            ErrorKind::Device, "no window with OpenGL 4.5 can be opened: " + why, "",
            "install a newer graphics driver, start it with LIBGL_ALWAYS_SOFTWARE=1, or use "
            "`teapath render`");
    }
    glfwMakeContextCurrent(window_);
    gladLoadGL(glfwGetProcAddress);
    glfwSwapInterval(1);
    gl_name_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    float scale_y = 1;
    glfwGetWindowContentScale(window_, &monitor_scale_, &scale_y);
    glfwSetWindowUserPointer(window_, this);
    glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float x, float) {
        static_cast<Window*>(glfwGetWindowUserPointer(w))->monitor_scale_ = x;
    });
    set_icon(window_);
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
        auto* self = static_cast<Window*>(glfwGetWindowUserPointer(w));
        for (int i = 0; i < count; ++i)
            self->drops_.emplace_back(paths[i]);
    });

    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImPlot::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.ConfigFlags |= ImGuiConfigFlags_DockingEnable | ImGuiConfigFlags_NavEnableKeyboard;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    ini_file_ = (configuration_folder() / "layout.ini").string();
    io.IniFilename = ini_file_.c_str();
    // Fonts are drawn at any size; the theme says at which.
    load_fonts(1);
    apply_theme(true, scale());
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 450");
}

Window::~Window() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImPlot::DestroyContext();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

bool Window::should_close() const {
    return glfwWindowShouldClose(window_);
}
void Window::set_should_close(bool close) {
    glfwSetWindowShouldClose(window_, close);
}
void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::begin_frame(double seconds) {
    if (seconds > 0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Window::draw() {
    ImGui::Render();
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    if (width < 1 || height < 1) return;
    glViewport(0, 0, width, height);
    glClearColor(0.4f, 0.4f, 0.4f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::show() {
    glfwSwapBuffers(window_);
}

bool Window::is_hidden() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return width < 1 || height < 1 || glfwGetWindowAttrib(window_, GLFW_ICONIFIED);
}

float Window::scale() const {
    const float scale = chosen_scale_ > 0 ? chosen_scale_ : monitor_scale_;
    return std::clamp(scale, 0.75f, 3.0f);
}

bool Window::is_full_screen() const {
    return glfwGetWindowMonitor(window_) != nullptr;
}

WindowPlace Window::place() const {
    WindowPlace place = windowed_;
    place.is_maximized = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) != 0;
    if (is_full_screen() || place.is_maximized) return place;
    glfwGetWindowPos(window_, &place.x, &place.y);
    glfwGetWindowSize(window_, &place.width, &place.height);
    return place;
}

void Window::put(const WindowPlace& place) {
    if (place.width < 1 || place.height < 1) return;
    windowed_ = place;
    glfwSetWindowSize(window_, place.width, place.height);
    // Enough of it to be taken hold of.
    if (monitor_of(place).second >= int64_t{100} * 40) glfwSetWindowPos(window_, place.x, place.y);
    if (place.is_maximized) glfwMaximizeWindow(window_);
}

void Window::toggle_full_screen() {
    if (is_full_screen()) {
        glfwSetWindowMonitor(window_, nullptr, windowed_.x, windowed_.y, windowed_.width,
                             windowed_.height, 0);
        return;
    }
    windowed_ = place();
    GLFWmonitor* monitor = monitor_of(windowed_).first;
    if (!monitor) monitor = glfwGetPrimaryMonitor();
    if (!monitor) return;
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::capture_cursor(bool capture) {
    glfwSetInputMode(window_, GLFW_CURSOR, capture ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    if (glfwRawMouseMotionSupported()) glfwSetInputMode(window_, GLFW_RAW_MOUSE_MOTION, capture);
    ImGuiIO& io = ImGui::GetIO();
    if (capture)
        io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
    else
        io.ConfigFlags &= ~ImGuiConfigFlags_NoMouseCursorChange;
}

std::vector<std::filesystem::path> Window::take_drops() {
    return std::exchange(drops_, {});
}

std::vector<unsigned char> Window::read_pixels(int& width, int& height) const {
    glfwGetFramebufferSize(window_, &width, &height);
    const auto row = 3 * static_cast<size_t>(width);
    std::vector<unsigned char> pixels(row * static_cast<size_t>(height)), flipped(pixels.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    for (size_t y = 0; y < static_cast<size_t>(height); ++y)
        std::copy_n(pixels.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                    flipped.end() - static_cast<std::ptrdiff_t>((y + 1) * row));
    return flipped;
}

}  // namespace tp
