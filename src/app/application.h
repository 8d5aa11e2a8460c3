// The window program as an object that is driven frame by frame: by run_app at the pace of the
// screen, by the tests at their own.
#pragma once

#include "context.h"
#include "preview/previews.h"

#include <teapath/app/app.h>

#include <filesystem>
#include <string>
#include <utility>

namespace tp {

class App {
public:
    /// Opens the window on the scene; where that cannot be read, on a new one with a message.
    /// Throws Error where no window can be opened.
    explicit App(const AppOptions& options);
    /// Remembers the window's place.
    ~App();
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    /// Waits at most `wait_seconds` for events, takes the newest picture and draws the interface,
    /// which may change the document. window.show() follows.
    void draw_frame(double wait_seconds);
    /// True once the user has closed the window and nothing is left to ask.
    bool is_closed() const;

    // In the order in which they are made: the device wakes up while the window opens, and what
    // lives in GL goes before the window.
    RenderWorker worker;
    UiState ui;
    Document document;
    Window window;
    DisplayTexture texture;
    ViewportLayers layers;
    Previews previews;
    RenderStatus status;  // of the frame drawn last

private:
    void show_newest_picture(PanelContext& c);
    void post_scene();
    void apply_look();

    std::filesystem::path preferences_file_;
    Preferences saved_preferences_;
    std::filesystem::path to_open_;  // by the first frame
    std::string title_;
    ScenePtr posted_;  // what the renderer was given last
    bool was_changed_ = false;
    std::pair<bool, float> look_{true, 0.0f};  // dark, scale: as applied last
};

}  // namespace tp
