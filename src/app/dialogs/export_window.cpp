// The export: what is rendered to files beside the window, and how.
#include "../widgets.h"
#include "dialogs.h"
#include "file_question.h"

#include <teapath/render/backend_names.h>
#include <teapath/render/output_files.h>
#include <teapath/scene/camera_path.h>
#include <teapath/scene/pose.h>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

namespace fs = std::filesystem;

void choose_file(PanelContext& c) {
    FileQuestion question;
    question.title = "Export to";
    question.accept = "Choose";
    question.saves = true;
    question.filters = picture_filters();
    question.purpose = "image";
    question.suggestion = c.ui.dialogs.exports.file;
    question.extension = ".png";
    question.then = [](PanelContext& p, const fs::path& file) { p.ui.dialogs.exports.file = file; };
    ask_for_file(c, std::move(question));
}

// Values of the scene, each time the window is opened on another document.
void begin(PanelContext& c) {
    DialogState& d = c.ui.dialogs;
    if (d.exports_of == c.document.file() && !d.exports.file.empty()) return;
    const fs::path file = d.exports.file;
    d.exports = export_settings_of(c.document.scene());
    d.exports_of = c.document.file();
    fs::path stem = c.document.file().empty() ? "untitled" : c.document.file().stem();
    const auto remembered = c.ui.preferences.folders.find("image");
    std::error_code ignored;
    const fs::path folder =
        !file.empty() ? file.parent_path()
        : remembered != c.ui.preferences.folders.end()
            ? fs::path(remembered->second)
            : (c.document.file().empty() ? fs::current_path(ignored)
                                         : fs::absolute(c.document.file()).parent_path());
    d.exports.file = folder / (stem += ".png");
}

void draw_file_row(PanelContext& c) {
    ExportSettings& s = c.ui.dialogs.exports;
    ui::label("File",
              "Its extension says the format: png and jpg as the window shows it; hdr and "
              "exr linear, exr with layers");
    std::string text = s.file.string();
    const float button = ImGui::GetFontSize() * 5;
    ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
    if (ImGui::InputText("##file", &text, ImGuiInputTextFlags_ElideLeft)) s.file = text;
    ImGui::SameLine();
    if (ImGui::Button("Choose\xe2\x80\xa6", ImVec2(button, 0))) choose_file(c);
}

void draw_size_row(PanelContext& c) {
    ExportSettings& s = c.ui.dialogs.exports;
    ui::label("Size", "Pixels of the picture");
    int size[2] = {s.width, s.height};
    const float button = ImGui::GetFontSize() * 5;
    ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
    if (ImGui::DragInt2("##size", size, 1, 1, 65536, "%d", ImGuiSliderFlags_AlwaysClamp)) {
        s.width = size[0];
        s.height = size[1];
    }
    ImGui::SameLine();
    if (ImGui::Button("Sizes##sizes", ImVec2(button, 0))) ImGui::OpenPopup("sizes");
    if (ImGui::BeginPopup("sizes")) {
        const RenderSettings& scene = c.document.scene().render;
        const struct {
            const char* name;
            int width, height;
        } sizes[] = {{"Scene", scene.width, scene.height},
                     {"Viewport", c.ui.viewport.width, c.ui.viewport.height},
                     {"HD", 1280, 720},
                     {"Full HD", 1920, 1080},
                     {"4K", 3840, 2160},
                     {"Square", 1080, 1080}};
        for (const auto& row : sizes)
            if (ImGui::MenuItem(row.name, fmt::format("{} x {}", row.width, row.height).c_str())) {
                s.width = row.width;
                s.height = row.height;
            }
        ImGui::EndPopup();
    }
}

void draw_camera_row(PanelContext& c) {
    ExportSettings& s = c.ui.dialogs.exports;
    const Scene& scene = c.document.scene();
    if (!find(scene, s.camera)) s.camera = active_camera(scene).id;
    const auto name = [&scene](const Camera& camera) {
        return item_name(scene, item_of(camera.id));
    };
    ui::label("Camera", "Where the picture is taken from");
    ImGui::SetNextItemWidth(-1);
    const Camera* current = find(scene, s.camera);
    if (ImGui::BeginCombo("##camera", current ? name(*current).c_str() : "")) {
        for (const Camera& camera : scene.cameras)
            if (ImGui::Selectable(fmt::format("{}##{}", name(camera), camera.id.value).c_str(),
                                  camera.id == s.camera))
                s.camera = camera.id;
        ImGui::EndCombo();
    }
}

void draw_seed_row(ExportSettings& s) {
    ui::label("Seed", "One picture for each seed");
    ImGui::SetNextItemWidth(-1);
    ImGui::InputScalar("##seed", ImGuiDataType_U64, &s.seed);
}

void draw_motion_rows(PanelContext& c) {
    ExportSettings& s = c.ui.dialogs.exports;
    const bool is_new = ui::row(
        "Motion", s.motion,
        "One picture, or frames: through the cameras \"bookmark 1\" to \"bookmark 9\" in turn, "
        "once round the point that the camera looks at, or as the models' animations play");
    const double length = animation_length(c.document.scene());
    if (is_new && s.motion == ExportMotion::Animation && length > 0)
        s.frames = std::clamp(static_cast<int>(std::ceil(length * s.frames_per_second)), 1, 9999);
    if (s.motion == ExportMotion::Still) return;
    ui::row("Frames", s.frames, 48, 1, 9999, "Number of pictures");
    ui::row("Rate", s.frames_per_second, 24.0, 0.1, 1.0, 1000.0, "%.3g /s",
            "Frames a second: the fixed time step between two");
    ui::row("New seeds", s.new_seeds,
            "Each frame has noise of its own; without it the noise stands still");
    ui::row_text("Length", fmt::format("{:.2f} s, {} to {}", s.frames / s.frames_per_second,
                                       frame_file(s, 0).filename().string(),
                                       frame_file(s, s.frames - 1).filename().string()));
}

const std::string& refusal_of_export(PanelContext& c) {
    DialogState& d = c.ui.dialogs;
    if (d.exports_checked_scene != c.document.snapshot() || d.exports_checked != d.exports) {
        d.exports_checked_scene = c.document.snapshot();
        d.exports_checked = d.exports;
        d.exports_refusal = why_not_exported(c.document.scene(), d.exports);
    }
    return d.exports_refusal;
}

void start(PanelContext& c) {
    const ExportSettings settings = c.ui.dialogs.exports;
    JobOptions options;
    options.title = fmt::format("Exporting {}", settings.file.filename().string());
    options.can_keep = true;
    options.is_gentle = true;
    options.failed = [settings](PanelContext& p, const std::string& error) {
        show_message(p.ui, fmt::format("{} is not exported", settings.file.filename().string()),
                     error);
    };
    const std::string name =
        c.document.file().empty() ? "untitled.json" : c.document.file().filename().string();
    c.ui.jobs.start(
        std::move(options),
        [settings, name, scene = c.document.snapshot()](JobControl& control) -> JobFinish {
            const ExportResult result = run_export(*scene, name, settings, control);
            return [result](PanelContext& p) {
                if (result.files.empty())
                    p.toast("Export stopped, nothing kept");
                else if (result.files.size() == 1)
                    p.toast(fmt::format("Wrote {} in {}{}", result.files[0].string(),
                                        clock_text(result.seconds),
                                        result.is_whole ? "" : ", cut short"));
                else
                    p.toast(fmt::format("Wrote {} to {}{}", result.files[0].string(),
                                        result.files.back().filename().string(),
                                        result.is_whole ? "" : ", cut short"));
            };
        });
}

}  // namespace

void draw_export_window(PanelContext& c) {
    if (!c.ui.dialogs.show_export) return;
    begin(c);
    const ImGuiViewport* main = ImGui::GetMainViewport();
    const ImVec2 most(main->WorkSize.x - 16, main->WorkSize.y - 16);
    ImGui::SetNextWindowSizeConstraints({0, 0}, most);
    ImGui::SetNextWindowSize({std::min(ImGui::GetFontSize() * 34, most.x), 0}, ImGuiCond_Appearing);
    ImGui::SetNextWindowPos(main->GetWorkCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
    if (ImGui::Begin("Export", &c.ui.dialogs.show_export,
                     ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoSavedSettings)) {
        ExportSettings& s = c.ui.dialogs.exports;
        if (ui::begin_rows("export")) {
            draw_file_row(c);
            draw_size_row(c);
            ui::row("Samples", s.samples, c.document.scene().render.samples, 1, 1 << 30,
                    "Per pixel");
            draw_seed_row(s);
            draw_camera_row(c);
            draw_motion_rows(c);
            ui::row(
                "Layers", s.features,
                "EXR only: also alpha, albedo, normal, depth and ids, as teapath render writes");
            ui::row("Backend", s.backend, "Where it is rendered; Automatic: CUDA where it works");
            ui::end_rows();
        }
        ImGui::Spacing();
        const std::string& why = refusal_of_export(c);
        if (ui::button("Export", why.empty(), why.c_str())) {
            start(c);
            c.ui.dialogs.show_export = false;
        }
        ImGui::SameLine();
        if (ImGui::Button("Close") ||
            (ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows) &&
             ImGui::IsKeyPressed(ImGuiKey_Escape) && !ImGui::IsAnyItemActive()))
            c.ui.dialogs.show_export = false;
        if (!why.empty()) {
            ImGui::PushTextWrapPos(0);
            ImGui::TextDisabled("%s", why.c_str());
            ImGui::PopTextWrapPos();
        }
    }
    ImGui::End();
}

}  // namespace tp
