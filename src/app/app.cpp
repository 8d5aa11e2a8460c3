// The frame loop: events, panels, renderer, picture.
// ImGuizmo needs ImGui before it.
// clang-format off
#include <imgui.h>
#include <ImGuizmo.h>
// clang-format on

#include <teapath/app/app.h>

#include <algorithm>
#include <chrono>

// After imgui.h, which it needs.
#include "actions.h"
#include "application.h"
#include "dialogs/dialogs.h"
#include "panels/panels.h"
#include "theme.h"

#include <teapath/core/error.h>
#include <teapath/io/image_file.h>
#include <teapath/render/backend_names.h>

#include <imgui_internal.h>

namespace tp {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// The default places of the panels around the picture.
void build_layout(ImGuiID dockspace) {
    const ImVec2 size = ImGui::GetMainViewport()->WorkSize;
    ImGui::DockBuilderRemoveNode(dockspace);
    ImGui::DockBuilderAddNode(dockspace, ImGuiDockNodeFlags_DockSpace);
    ImGui::DockBuilderSetNodeSize(dockspace, size);
    ImGuiID middle = dockspace;
    const float font = ImGui::GetFontSize();
    const float side = std::clamp(18 * font / size.x, 0.12f, 0.23f),
                low = std::clamp(12 * font / size.y, 0.12f, 0.28f);
    const ImGuiID bottom =
        ImGui::DockBuilderSplitNode(middle, ImGuiDir_Down, low, nullptr, &middle);
    const ImGuiID left = ImGui::DockBuilderSplitNode(middle, ImGuiDir_Left, side, nullptr, &middle);
    ImGuiID right =
        ImGui::DockBuilderSplitNode(middle, ImGuiDir_Right, side / (1 - side), nullptr, &middle);
    const ImGuiID inspector =
        ImGui::DockBuilderSplitNode(right, ImGuiDir_Down, 0.58f, nullptr, &right);
    ImGuiID console = bottom;
    const ImGuiID metrics =
        ImGui::DockBuilderSplitNode(console, ImGuiDir_Right, 0.5f, nullptr, &console);
    ImGui::DockBuilderDockWindow("Viewport", middle);
    ImGui::DockBuilderDockWindow("Options", left);
    ImGui::DockBuilderDockWindow("Scene", right);
    ImGui::DockBuilderDockWindow("Inspector", inspector);
    ImGui::DockBuilderDockWindow("Console", console);
    ImGui::DockBuilderDockWindow("Metrics", metrics);
    ImGui::DockBuilderDockWindow("History", metrics);
    // The tab in front is the one that was docked last, once its window is there.
    if (ImGuiDockNode* node = ImGui::DockBuilderGetNode(metrics))
        node->SelectedTabId = ImHashStr("#TAB", 0, ImHashStr("Metrics"));
    if (ImGuiDockNode* node = ImGui::DockBuilderGetNode(middle))
        node->LocalFlags |= ImGuiDockNodeFlags_HiddenTabBar;
    ImGui::DockBuilderFinish(dockspace);
}

void draw_panels(PanelContext& c) {
    ImGuizmo::BeginFrame();
    draw_menu_bar(c);
    draw_status_bar(c);
    const ImGuiID dockspace = ImGui::GetID("dockspace");
    if (c.ui.reset_layout || !ImGui::DockBuilderGetNode(dockspace)) build_layout(dockspace);
    c.ui.reset_layout = false;
    ImGui::DockSpaceOverViewport(dockspace, ImGui::GetMainViewport(), ImGuiDockNodeFlags_None);
    draw_viewport(c);
    draw_options(c);
    draw_scene_tree(c);
    draw_inspector(c);
    draw_console(c);
    draw_metrics(c);
    draw_history(c);
    draw_dialogs(c);
    run_shortcuts(c);
}

void remember_times(MetricsState& metrics, double interface_ms, const RenderStatus& status) {
    const size_t i = metrics.frames++ % MetricsState::kFrames;
    metrics.interface_ms[i] = static_cast<float>(interface_ms);
    metrics.trace_ms[i] = static_cast<float>(status.step_ms);
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

// The document to begin with; its render starts before there is a window.
Document first_document(const AppOptions& options, RenderWorker& worker) {
    Document document;
    if (!options.scene.empty()) document.open(options.scene);
    const ViewportState viewport;
    worker.set_scene(document.snapshot(), viewport.width, viewport.height, false);
    return document;
}

}  // namespace

App::App(const AppOptions& options)
    : worker(session_options(options)),
      document(first_document(options, worker)),
      window(options.width, options.height, "Teapath") {
    preferences_file_ = configuration_folder() / "settings.json";
    ui.preferences = load_preferences(preferences_file_);
    ui.keys.from_names(ui.preferences.keys);
    saved_preferences_ = ui.preferences;
    apply_theme(ui.preferences.dark_theme, window.scale());
}

void App::draw_frame(double wait_seconds) {
    window.begin_frame(wait_seconds);
    const auto frame_start = Clock::now();

    // The newest picture.
    if (worker.take_frame(frame_.serial, frame_)) {
        texture.upload(frame_.rgb, frame_.width, frame_.height);
        ui.metrics.upload_ms = ms_since(frame_start);
    }

    // The interface, which may change the document.
    status = worker.status();
    PanelContext context{document, worker, ui, texture, window, status};
    for (const std::filesystem::path& file : window.take_drops())
        open_scene(context, file);
    draw_panels(context);
    worker.set_scene(document.snapshot(), ui.viewport.width, ui.viewport.height,
                     ui.viewport.is_moving);
    if (title_ != document.title()) window.set_title((title_ = document.title()) + " - Teapath");
    if (ui.preferences != saved_preferences_)
        save_preferences(saved_preferences_ = ui.preferences, preferences_file_);
    remember_times(ui.metrics, ms_since(frame_start), status);
    window.draw();
}

bool App::is_closed() const {
    return window.should_close() && (!document.is_modified() || ui.dialogs.pending.empty());
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
