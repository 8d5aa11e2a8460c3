// The GLFW window with its GL context and Dear ImGui on top; move-free RAII.
#pragma once

#include "preferences.h"

#include <filesystem>
#include <string>
#include <vector>

struct GLFWwindow;

namespace tp {

class Window {
public:
    /// Throws Error(Device) where there is no display or no OpenGL 4.5.
    Window(int width, int height, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    bool should_close() const;
    void set_should_close(bool close);
    void set_title(const std::string& title);

    /// Waits for events at most `seconds`, and begins a frame of the interface.
    void begin_frame(double seconds);
    /// Draws the interface; read_pixels sees it then.
    void draw();
    /// Shows what was drawn.
    void show();
    /// True where there is nothing to draw on, as when minimised.
    bool is_hidden() const;

    /// On the monitor that shows most of the window, and back to where it was.
    void toggle_full_screen();
    bool is_full_screen() const;

    /// Where the window is, or was before it became full screen or maximised.
    WindowPlace place() const;
    /// Puts the window where it was, if that is still on a monitor; its size in any case.
    void put(const WindowPlace& place);

    void capture_cursor(bool capture);

    /// Files dropped since the last call.
    std::vector<std::filesystem::path> take_drops();

    /// The drawn pixels, RGB, top row first; between draw and show.
    std::vector<unsigned char> read_pixels(int& width, int& height) const;

    /// Of the interface: the chosen one, else from the monitor that the window is on.
    float scale() const;
    /// 0.75 to 3, or 0 for the monitor's. Theme and fonts follow with `apply_theme`.
    void set_interface_scale(float scale) { chosen_scale_ = scale; }
    const std::string& gl_name() const { return gl_name_; }

private:
    GLFWwindow* window_ = nullptr;
    float monitor_scale_ = 1;
    float chosen_scale_ = 0;
    std::string gl_name_;
    std::vector<std::filesystem::path> drops_;
    WindowPlace windowed_{0, 0, 1280, 720, false};  // while it is not full screen or maximised
    std::string ini_file_;
};

}  // namespace tp
