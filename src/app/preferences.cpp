#include "preferences.h"

#include <teapath/core/log.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <system_error>

namespace tp {
namespace {

using Json = nlohmann::json;

// Takes the value of `key` where it is there and of the right type.
template <class T>
void take(const Json& json, const char* key, T& value) {
    const auto found = json.find(key);
    if (found == json.end()) return;
    try {
        value = found->get<T>();
    } catch (const Json::exception&) {
        log_warning("settings: {} is not what it should be and is left as it was", key);
    }
}

}  // namespace

void Preferences::remember_file(const std::filesystem::path& file) {
    const std::string name = std::filesystem::absolute(file).lexically_normal().string();
    std::erase(recent_files, name);
    recent_files.insert(recent_files.begin(), name);
    if (recent_files.size() > kMaxRecent) recent_files.resize(kMaxRecent);
}

bool Preferences::is_panel_open(std::string_view title) const {
    return std::find(closed_panels.begin(), closed_panels.end(), title) == closed_panels.end();
}

void Preferences::set_panel_open(const std::string& title, bool open) {
    if (open)
        std::erase(closed_panels, title);
    else if (is_panel_open(title))
        closed_panels.push_back(title);
}

std::filesystem::path configuration_folder() {
    const char* xdg = std::getenv("XDG_CONFIG_HOME");
    const char* home = std::getenv("HOME");
    std::filesystem::path folder = xdg && *xdg
                                       ? std::filesystem::path(xdg)
                                       : std::filesystem::path(home ? home : ".") / ".config";
    folder /= "teapath";
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    return folder;
}

Preferences load_preferences(const std::filesystem::path& file) {
    Preferences p;
    std::ifstream in(file);
    if (!in) return p;
    const Json json = Json::parse(in, nullptr, false);
    if (!json.is_object()) {
        log_warning("settings: {} is broken; the defaults are used", file.string());
        return p;
    }
    take(json, "dark_theme", p.dark_theme);
    take(json, "interface_scale", p.interface_scale);
    take(json, "seen_welcome", p.seen_welcome);
    take(json, "smooth_picture", p.smooth_picture);
    take(json, "ground_grid", p.ground_grid);
    take(json, "fly_speed", p.fly_speed);
    take(json, "look_degrees", p.look_degrees);
    take(json, "autosave_minutes", p.autosave_minutes);
    take(json, "native_dialogs", p.native_dialogs);
    take(json, "closed_panels", p.closed_panels);
    take(json, "folders", p.folders);
    std::array<int, 5> window{};
    take(json, "window", window);
    if (window[2] > 0 && window[3] > 0)
        p.window = {window[0], window[1], window[2], window[3], window[4] != 0};
    take(json, "recent_files", p.recent_files);
    take(json, "keys", p.keys);
    take(json, "folded", p.folded);
    take(json, "viewport_resolution", p.viewport.resolution_percent);
    take(json, "viewport_moving_divider", p.viewport.moving_divider);
    std::string way;
    take(json, "display_way", way);
    p.viewport.display_way = enum_value<DisplayWay>(way).value_or(DisplayWay::Auto);
    p.viewport.resolution_percent = std::clamp(p.viewport.resolution_percent, 10, 100);
    p.viewport.moving_divider = std::clamp(p.viewport.moving_divider, 0, 8);
    p.interface_scale = p.interface_scale > 0 ? std::clamp(p.interface_scale, 0.75f, 3.0f) : 0;
    p.fly_speed = std::clamp(p.fly_speed, 0.1, 10.0);
    p.look_degrees = std::clamp(p.look_degrees, 0.01, 1.0);
    p.autosave_minutes = std::clamp(p.autosave_minutes, 0, 60);
    if (p.recent_files.size() > Preferences::kMaxRecent)
        p.recent_files.resize(Preferences::kMaxRecent);
    return p;
}

void save_preferences(const Preferences& p, const std::filesystem::path& file) {
    const WindowPlace& w = p.window;
    const std::array<int, 5> window = {w.x, w.y, w.width, w.height, w.is_maximized ? 1 : 0};
    const Json json = {{"dark_theme", p.dark_theme},
                       {"interface_scale", p.interface_scale},
                       {"seen_welcome", p.seen_welcome},
                       {"smooth_picture", p.smooth_picture},
                       {"ground_grid", p.ground_grid},
                       {"fly_speed", p.fly_speed},
                       {"look_degrees", p.look_degrees},
                       {"autosave_minutes", p.autosave_minutes},
                       {"native_dialogs", p.native_dialogs},
                       {"window", window},
                       {"closed_panels", p.closed_panels},
                       {"folders", p.folders},
                       {"recent_files", p.recent_files},
                       {"keys", p.keys},
                       {"folded", p.folded},
                       {"viewport_resolution", p.viewport.resolution_percent},
                       {"viewport_moving_divider", p.viewport.moving_divider},
                       {"display_way", enum_name(p.viewport.display_way)}};
    std::filesystem::path part = file;
    part += ".part";
    std::error_code error;
    {
        std::ofstream out(part);
        out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
        if (!out.flush()) error = std::make_error_code(std::errc::io_error);
    }
    if (!error) std::filesystem::rename(part, file, error);
    if (error) log_warning("settings: {} cannot be written ({})", file.string(), error.message());
}

}  // namespace tp
