// One line at the bottom: what renders, how far, how fast.
#include "../figures.h"
#include "../jobs/jobs_view.h"
#include "../theme.h"
#include "../widgets.h"
#include "panels.h"
#include "render_figures.h"

#include <fmt/format.h>
#include <icons_font_awesome_6.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

namespace tp {
namespace {

// One part of the line; those of lower rank go first where it is too long.
struct Part {
    std::string text;
    int rank = 0;
    const char* help = "";
};

std::vector<Part> parts_of(const PanelContext& c) {
    const RenderStatus& s = c.status;
    std::vector<Part> parts;
    parts.push_back({s.backend.empty() ? "Starting\xe2\x80\xa6" : s.backend, 3, "What renders"});
    parts.push_back({fmt::format("{} \xc3\x97 {}", s.width, s.height), 2, "Pixels of the picture"});
    parts.push_back({fmt::format("{} / {} spp", s.samples, c.document.scene().render.samples), 5,
                     "Samples of each pixel"});
    if (!c.ui.paused && !s.is_done && s.samples_per_second > 0)
        parts.push_back({count_text(s.samples_per_second) + "samples/s", 1, "Camera samples"});
    if (const std::string left = time_left_text(c); !left.empty() && !c.ui.paused)
        parts.push_back({left, 4, "Until all samples are there"});
    if (s.memory_bytes > 0) parts.push_back({memory_text(s.memory_bytes), 0, "Scene and film"});
    return parts;
}

// Leaves out parts, the least first, until the line fits.
void fit(std::vector<Part>& parts, float width, float gap) {
    const auto total = [&] {
        float sum = 0;
        for (const Part& p : parts)
            sum += ImGui::CalcTextSize(p.text.c_str()).x + gap;
        return sum;
    };
    while (parts.size() > 1 && total() > width)
        parts.erase(std::min_element(parts.begin(), parts.end(),
                                     [](const Part& a, const Part& b) { return a.rank < b.rank; }));
}

void draw_progress(const PanelContext& c) {
    const double share = share_done(c);
    if (share <= 0 || share >= 1) return;
    const ImVec2 low = ImGui::GetWindowPos();
    const float width = ImGui::GetWindowWidth() * static_cast<float>(share);
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + ui::px(2)},
                                              ImGui::GetColorU32(to_color(theme().accent)));
}

void draw_parts(PanelContext& c) {
    const float gap = ImGui::GetFontSize() * 1.2f;
    float width = ImGui::GetContentRegionAvail().x;
    if (c.ui.paused) {
        const char* const text = ICON_FA_PAUSE "  Paused";
        ImGui::TextColored(to_color(theme().accent_text), "%s", text);
        width -= ImGui::CalcTextSize(text).x + gap;
        ImGui::SameLine(0, gap);
    }
    if (!c.status.error.empty()) {
        const std::string text =
            ui::fitted(ICON_FA_TRIANGLE_EXCLAMATION "  " + c.status.error, width * 0.6f);
        ImGui::TextColored(to_color(theme().error), "%s", text.c_str());
        ui::tooltip(c.status.error.c_str());
        width -= ImGui::CalcTextSize(text.c_str()).x + gap;
        ImGui::SameLine(0, gap);
    }
    std::vector<Part> parts = parts_of(c);
    fit(parts, width, gap);
    for (size_t i = 0; i < parts.size(); ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        ImGui::TextUnformatted(ui::fitted(parts[i].text, width).c_str());
        ui::tooltip(parts[i].help);
    }
}

}  // namespace

void draw_status_bar(PanelContext& c) {
    const float height = ImGui::GetFrameHeight();
    const ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_MenuBar;
    if (ImGui::BeginViewportSideBar("##status", ImGui::GetMainViewport(), ImGuiDir_Down, height,
                                    flags)) {
        if (ImGui::BeginMenuBar()) {
            draw_parts(c);
            draw_jobs(c);
            ImGui::EndMenuBar();
        }
        draw_progress(c);
    }
    ImGui::End();
}

}  // namespace tp
