// What a panel, an action or a dialog is given: the document, the renderer, the window, and the
// state of the interface, which has a part for each panel. No copy of a scene value lives here.
#pragma once

#include "display/display_texture.h"
#include "display/viewport_layers.h"
#include "jobs/autosave.h"
#include "jobs/export_job.h"
#include "jobs/jobs.h"
#include "keymap.h"
#include "preferences.h"
#include "render_worker.h"
#include "viewport/gizmo_drag.h"
#include "viewport/navigation.h"
#include "viewport/picture_place.h"
#include "window.h"

#include <teapath/core/log.h>
#include <teapath/editor/document.h>
#include <teapath/editor/scene_tree.h>

#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <typeindex>
#include <vector>

namespace tp {

enum class Tool { Select, Move, Rotate, Scale, Focus };

/// A short notice at the viewport's corner.
struct Toast {
    std::string text;
    double until = 0;  // seconds of ImGui's clock
    bool is_error = false;
};

struct ViewportState {
    int width = 640;  // pixels of the picture: of the panel, or of the scene file
    int height = 360;
    bool is_moving = false;   // a flight or drag is under way in this frame
    bool has_focus = false;   // keys of the viewport act
    bool is_looking = false;  // the right button is held
    bool wants_focus = true;  // to be given the keyboard in the next frame

    // Flying.
    double fly_speed = 0;          // scene units a second; 0 = to be set from the scene
    double speed_shown_until = 0;  // seconds of ImGui's clock
    NavigationState navigation;
    std::optional<Double2> click;  // where the left button went down, while it may become a click

    // The picture in its panel.
    bool fixed_size = false;  // the scene file's size instead of the panel's
    PictureView view;
    Double2 panel_size{640, 360};      // as drawn last, in the screen's units
    Double2 picture_pixels{640, 360};  // of the picture at zoom 1, in the screen's units

    // Tools.
    Tool tool = Tool::Select;
    bool local_axes = false;  // of the active object instead of the world's
    bool snap = false;
    float move_step = 0.1f;     // scene units
    float rotate_step = 15.0f;  // degrees
    float scale_step = 0.1f;    // of the size at the drag's beginning
    GizmoDrag gizmo;
};

/// The play of the models' animations; the time itself is the scene's.
struct TimelineState {
    bool is_playing = false;
    bool loops = true;
    float frames_per_second = 24;  // the time goes in steps of one over it
    double position = 0;           // seconds, between the steps, while it plays
};

struct SceneTreeState {
    std::string search;
    SceneTree rows;
    SceneItem anchor;          // where a range begins that Shift selects
    bool is_renaming = false;  // a name is being typed in place
    SceneItem renamed;         // of that thing
    std::string rename_text;
    SceneItem shown;                    // the selection that was last scrolled to
    std::vector<SceneItem> menu_items;  // what the open menu acts on
};

struct ConsoleState {
    std::deque<LogLine> lines;
    std::string filter;
    std::string search;
    std::array<bool, 4> shows{false, true, true, true};  // by LogLevel
    uint64_t cleared = 0;  // serial of the last line that Clear took away
    uint64_t found = 0;    // serial of the line that the search is at; 0 = none
};

/// The last frames' times, as rings.
struct MetricsState {
    static constexpr size_t kFrames = 240;
    std::array<float, kFrames> frame_ms{};      // from one frame to the next
    std::array<float, kFrames> interface_ms{};  // panels and what draws them
    std::array<float, kFrames> trace_ms{};
    std::array<float, kFrames> display_ms{};  // tone curve and copy
    std::array<float, kFrames> show_ms_of_frame{};
    size_t frames = 0;   // since the start
    double show_ms = 0;  // from the renderer to the texture, of the last picture
};

struct FileDialog;

/// A message that stays until it is closed.
struct Message {
    std::string title, text;
};

/// What waits for unsaved changes to be settled.
struct PendingStep {
    std::string verb;  // "closing the window", for the question
    std::function<void(PanelContext&)> then;
};

struct DialogState {
    bool show_keys = false;
    bool show_settings = false;
    std::string key_to_set;      // id of the action that waits for its new key in the settings
    int key_slot = 0;            // which of its two
    bool key_was_taken = false;  // in this frame
    std::string key_search;
    bool show_export = false;
    bool show_save_layout = false;
    std::shared_ptr<FileDialog> file;  // the question for a file that is open
    PendingStep pending;               // then == null: no question
    std::deque<Message> messages;
    ExportSettings exports;
    std::filesystem::path exports_of;  // the document that `exports` was filled from
    // What was last asked of the disk, and its answer.
    ExportSettings exports_checked;
    ScenePtr exports_checked_scene;
    std::string exports_refusal;
    std::filesystem::path window_image;  // where the window's pixels of this frame go, if anywhere
    std::string layout_name;
    bool asks_to_stop = false;  // whether to quit although an export runs
    bool quits = false;         // all is settled: the program ends
};

class Previews;

struct LayoutState {
    std::string built_in;               // to be built in the next frame: "Edit", "Render" …
    std::string places;                 // ImGui's, to be taken before the next frame
    std::vector<std::string> saved;     // names, as of the last look
    std::vector<std::string> in_front;  // panels whose tabs are to be in front …
    int frames_to_front = 0;            // … after so many frames
    bool is_stale = true;               // the folder is to be read again
};

/// What one panel's file alone knows between frames: a value for each type, made at first use. It
/// ends with the interface, as a static variable would not.
class LocalState {
public:
    template <class T>
    T& get() {
        std::shared_ptr<void>& value = values_[typeid(T)];
        if (!value) value = std::make_shared<T>();
        return *static_cast<T*>(value.get());
    }

private:
    std::map<std::type_index, std::shared_ptr<void>> values_;
};

struct UiState {
    mutable LocalState local;
    Preferences preferences;
    Previews* previews = nullptr;  // null where no pictures can be shown
    KeyMap keys;
    const char* last_action = "";  // the id of the action that ran last
    bool paused = false;
    bool reset_layout = false;
    ViewportState viewport;
    TimelineState timeline;
    SceneTreeState tree;
    ConsoleState console;
    MetricsState metrics;
    SessionOptions session;       // what the renderer is to run on
    SessionOptions used_session;  // what it was last told
    DialogState dialogs;
    LayoutState layout;
    std::deque<Toast> toasts;
    Autosave autosave;
    Jobs jobs;  // last: it goes first, and waits for its threads
};

struct PanelContext {
    Document& document;
    RenderWorker& worker;
    UiState& ui;
    DisplayTexture& texture;
    ViewportLayers& layers;
    Window& window;
    const RenderStatus& status;

    /// Shows a notice for some seconds and writes it to the log.
    void toast(const std::string& text, bool is_error = false);
    void set_paused(bool paused);
};

}  // namespace tp
