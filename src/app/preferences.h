// What the program remembers of a user between starts: a JSON file in the configuration folder.
// Nothing here belongs to a scene.
#pragma once

#include "display/display_way.h"

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// How the picture in the window is rendered; files are not touched by it.
struct ViewportPreferences {
    int resolution_percent = 100;  // of the panel's pixels, 10 to 100
    int moving_divider = 0;        // of the resolution while something moves; 0 = by speed
    DisplayWay display_way = DisplayWay::Auto;

    friend bool operator==(const ViewportPreferences&, const ViewportPreferences&) = default;
};

/// Where the window was, in screen coordinates; a width of 0: nowhere yet.
struct WindowPlace {
    int x = 0, y = 0, width = 0, height = 0;
    bool is_maximized = false;

    friend bool operator==(const WindowPlace&, const WindowPlace&) = default;
};

struct Preferences {
    bool dark_theme = true;
    float interface_scale = 0;   // 0 = from the monitor; else 0.75 to 3
    bool seen_welcome = false;   // the card of the first start
    bool smooth_picture = true;  // a picture that is not shown pixel by pixel is interpolated
    bool ground_grid = false;    // lines on the plane y = 0
    double fly_speed = 1;        // times the natural speed of the scene, 0.1 to 10
    double look_degrees = 0.1;   // that a pixel of the mouse turns the camera, 0.01 to 1
    int autosave_minutes = 2;    // 0 = off, up to 60
    bool native_dialogs = true;  // the desktop's own file dialogs, where it has some
    WindowPlace window;          // at the last end
    std::vector<std::string> closed_panels;      // by their titles
    std::map<std::string, std::string> folders;  // the last one for each purpose: "scene", "image"
    std::vector<std::string> recent_files;       // the newest first, at most kMaxRecent
    std::map<std::string, std::array<std::string, 2>> keys;  // see KeyMap::to_names
    ViewportPreferences viewport;
    std::vector<std::string> folded;  // headings of panels that are folded

    static constexpr size_t kMaxRecent = 12;

    /// Puts a file at the head of the recent ones.
    void remember_file(const std::filesystem::path& file);
    bool is_panel_open(std::string_view title) const;
    void set_panel_open(const std::string& title, bool open);
    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// The user's folder for settings and layouts ($XDG_CONFIG_HOME or ~/.config, teapath); created.
std::filesystem::path configuration_folder();

/// What `file` holds; defaults for what is missing, and a line in the log where it is broken.
Preferences load_preferences(const std::filesystem::path& file);

/// Writes them whole or not at all; a failure is a line in the log.
void save_preferences(const Preferences& preferences, const std::filesystem::path& file);

}  // namespace tp
