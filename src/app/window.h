// The GLFW window with its GL context and Dear ImGui on top; move-free RAII.
#pragma once

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

    void toggle_full_screen();
    void capture_cursor(bool capture);

    /// Files dropped since the last call.
    std::vector<std::filesystem::path> take_drops();

    /// The drawn pixels, RGB, top row first; between draw and show.
    std::vector<unsigned char> read_pixels(int& width, int& height) const;

    float scale() const { return scale_; }  // of the interface, from the monitor
    const std::string& gl_name() const { return gl_name_; }

private:
    GLFWwindow* window_ = nullptr;
    float scale_ = 1;
    std::string gl_name_;
    std::vector<std::filesystem::path> drops_;
    int windowed_[4] = {0, 0, 1280, 720};
    std::string ini_file_;
};

}  // namespace tp
