// The frame loop: events, panels, renderer, picture.
// ImGuizmo needs ImGui before it.
// clang-format off
#include <imgui.h>
#include <ImGuizmo.h>
// clang-format on

#include <teapath/app/app.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <utility>

// After imgui.h, which it needs.
#include "actions.h"
#include "application.h"
#include "dialogs/dialogs.h"
#include "dialogs/file_question.h"
#include "layouts.h"
#include "panels/panels.h"
#include "theme.h"

#include <teapath/core/error.h>
#include <teapath/io/image_file.h>
#include <teapath/io/model_file.h>
#include <teapath/render/backend_names.h>

namespace tp {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void draw_panels(PanelContext& c) {
    ImGuizmo::BeginFrame();
    draw_menu_bar(c);
    draw_status_bar(c);
    draw_dock_space(c);
    draw_open_panels(c);
    draw_dialogs(c);
    run_shortcuts(c);
}

void remember_times(MetricsState& metrics, double interface_ms, const RenderStatus& status) {
    const size_t i = metrics.frames++ % MetricsState::kFrames;
    metrics.interface_ms[i] = static_cast<float>(interface_ms);
    metrics.frame_ms[i] = ImGui::GetIO().DeltaTime * 1000;
    metrics.trace_ms[i] = static_cast<float>(status.step_ms);
    metrics.display_ms[i] = static_cast<float>(status.display_ms);
    metrics.show_ms_of_frame[i] = static_cast<float>(metrics.show_ms);
}

void write_screenshot(const Window& window, const std::filesystem::path& file) {
    Picture picture;
    picture.display = window.read_pixels(picture.width, picture.height);
    write_picture(file, picture);
}

SessionOptions session_options(const AppOptions& options) {
    SessionOptions session;
    session.backend = options.backend == "cuda"   ? BackendKind::Cuda
                      : options.backend == "host" ? BackendKind::Host
                                                  : BackendKind::Auto;
    session.device = options.device;
    session.threads = options.threads;
    return session;
}

void start_log_file() {
    const std::string problem = log_to_file((state_folder() / "teapath.log").string());
    if (!problem.empty()) log_warning("there is no log file: {}", problem);
}

// The document to begin with; its render starts before there is a window. A scene that cannot be
// read is a message, in the log file too. Models take longer: they are opened by a job of the
// window.
Document first_document(const AppOptions& options, RenderWorker& worker, UiState& ui) {
    start_log_file();
    Document document;
    try {
        if (!options.scene.empty() && !can_read_model(options.scene)) document.open(options.scene);
    } catch (const std::exception& error) {
        show_unreadable(ui, options.scene, error.what());
    }
    const ViewportState viewport;
    worker.set_scene(document.snapshot(), viewport.width, viewport.height, false);
    return document;
}

}  // namespace

App::App(const AppOptions& options)
    : worker(session_options(options)),
      document(first_document(options, worker, ui)),
      window(options.width > 0 ? options.width : 1280, options.height > 0 ? options.height : 720,
             "Teapath") {
    preferences_file_ = configuration_folder() / "settings.json";
    ui.preferences = load_preferences(preferences_file_);
    ui.keys.from_names(ui.preferences.keys);
    saved_preferences_ = ui.preferences;
    ui.previews = &previews;
    ui.session = ui.used_session = session_options(options);
    if (options.width <= 0 && options.height <= 0) window.put(ui.preferences.window);
    if (!document.file().empty()) ui.preferences.remember_file(document.file());
    const char* autosave_seconds = std::getenv("TEAPATH_AUTOSAVE_SECONDS");
    ui.autosave.start(state_folder() / "autosave",
                      autosave_seconds ? std::atof(autosave_seconds) : 0);
    look_for_native_dialogs();
    if (can_read_model(options.scene)) to_open_ = options.scene;
}

App::~App() {
    worker.stop();  // its threads would slow down what ends before it
    ui.preferences.window = window.place();
    if (ui.preferences != saved_preferences_) save_preferences(ui.preferences, preferences_file_);
}

// Theme and scale of the interface as they are to be from this frame on.
void App::apply_look() {
    window.set_interface_scale(ui.preferences.interface_scale);
    const std::pair<bool, float> look{ui.preferences.dark_theme, window.scale()};
    if (look == look_) return;
    look_ = look;
    apply_theme(look.first, look.second);
    // Fonts are drawn at any size; a panel's cross shows under the pointer.
    ImGui::GetStyle().FontScaleDpi = look.second;
    ImGui::GetStyle().TabCloseButtonMinWidthSelected = 0;
}

void App::show_newest_picture(PanelContext& c) {
    texture.set_way(ui.preferences.viewport.display_way);
    if (auto image = worker.take_image()) texture.set_image(std::move(*image));
    try {
        texture.update(document.scene().display);
    } catch (const Error& error) {
        // The renderer meets the same trouble and goes on with the host.
        texture.release_device();
        c.toast(error.what(), true);
    }
    ui.metrics.show_ms = texture.show_ms();
}

void App::post_scene() {
    // What changes in frame after frame is a drag or a flight.
    const bool is_changed = document.snapshot() != posted_;
    const double share =
        ui.viewport.fixed_size ? 1 : ui.preferences.viewport.resolution_percent / 100.0;
    const auto pixels = [share](int length) {
        return std::max(1, static_cast<int>(std::lround(length * share)));
    };
    worker.set_scene(document.snapshot(), pixels(ui.viewport.width), pixels(ui.viewport.height),
                     ui.viewport.is_moving || (is_changed && was_changed_));
    was_changed_ = is_changed;
    posted_ = document.snapshot();
}

void App::draw_frame(double wait_seconds) {
    apply_look();
    apply_saved_layout(ui);
    window.begin_frame(wait_seconds);
    const auto frame_start = Clock::now();

    status = worker.status();
    PanelContext context{document, worker, ui, texture, layers, window, status};
    show_newest_picture(context);

    // The interface, which may change the document.
    if (!to_open_.empty()) open_scene(context, std::exchange(to_open_, {}));
    for (const std::filesystem::path& file : window.take_drops())
        drop_file(context, file);
    previews.begin_frame();
    draw_panels(context);
    post_scene();
    if (title_ != document.title()) window.set_title((title_ = document.title()) + " - Teapath");
    if (ui.preferences != saved_preferences_)
        save_preferences(saved_preferences_ = ui.preferences, preferences_file_);
    remember_times(ui.metrics, ms_since(frame_start), status);
    window.draw();
    take_window_image(context);
}

bool App::is_closed() const {
    return ui.dialogs.quits;
}

int run_app(const AppOptions& options) {
    App app(options);
    const auto start = Clock::now();
    for (double next_frame_ms = 0;;) {
        // Sixty frames a second at most.
        const double wait_ms = std::max(0.0, next_frame_ms - ms_since(start));
        next_frame_ms = ms_since(start) + wait_ms + 1000.0 / 60;
        app.draw_frame(wait_ms / 1e3);
        const bool is_last = options.quit_after > 0 && ms_since(start) > options.quit_after * 1e3;
        if (is_last && !options.screenshot.empty())
            write_screenshot(app.window, options.screenshot);
        app.window.show();
        if (is_last || app.is_closed()) return 0;
    }
}

}  // namespace tp
