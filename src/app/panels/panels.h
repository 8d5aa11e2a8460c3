// The panels of the window: one function each, given the document, the renderer and the state of
// the interface. Panels hold no copy of a scene value.
#pragma once

#include "../display_texture.h"
#include "../render_worker.h"
#include "../window.h"

#include <teapath/core/log.h>
#include <teapath/editor/document.h>

#include <cstdint>
#include <deque>
#include <filesystem>
#include <string>
#include <vector>

namespace tp {

enum class Tool { Select, Move, Rotate, Scale };

/// A short notice at the viewport's corner.
struct Toast {
    std::string text;
    double until = 0;  // seconds of ImGui's clock
    bool is_error = false;
};

/// What belongs to the interface alone.
struct UiState {
    bool paused = false;
    bool is_moving = false;  // a flight or drag is under way in this frame
    int view_width = 640;    // pixels of the picture
    int view_height = 360;
    double fly_speed = 0;  // scene units a second; 0 = to be set from the scene
    Tool tool = Tool::Select;
    bool snap = false;
    MaterialId chosen_material;  // shown in the inspector where no object is selected
    std::string search;
    std::string log_filter;
    std::vector<LogLine> log;
    bool log_follow = true;
    bool show_about = false, show_keys = false;
    bool show_open = false, show_save_as = false, show_export = false;
    std::string path_input;
    std::string pending;  // what to do once unsaved changes are settled: "quit", "new", "open"
    bool dark = true;
    bool reset_layout = false;
    std::deque<Toast> toasts;
    float frame_ms[240] = {};
    float trace_ms[240] = {};
    int frame_count = 0;
    double upload_ms = 0;
};

struct PanelContext {
    Document& document;
    RenderWorker& worker;
    UiState& ui;
    DisplayTexture& texture;
    Window& window;
    const RenderStatus& status;
    void toast(const std::string& text, bool is_error = false);
};

void draw_menu_bar(PanelContext& c);
void draw_dialogs(PanelContext& c);
void draw_viewport(PanelContext& c);
void draw_options(PanelContext& c);
void draw_scene_tree(PanelContext& c);
void draw_inspector(PanelContext& c);
void draw_metrics(PanelContext& c);
void draw_console(PanelContext& c);
void draw_history(PanelContext& c);
void draw_status_bar(PanelContext& c);

/// Opens a scene file; a broken one is a notice, and the old scene stays.
void open_scene(PanelContext& c, const std::filesystem::path& file);
/// Saves under the document's name, or asks for one.
void save_scene_or_ask(PanelContext& c);

}  // namespace tp
