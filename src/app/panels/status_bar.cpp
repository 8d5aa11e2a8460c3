// One line at the bottom: what renders, how far, how fast.
#include "../jobs/jobs_view.h"
#include "panels.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

namespace tp {

void draw_status_bar(PanelContext& c) {
    const float height = ImGui::GetFrameHeight();
    const ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_MenuBar;
    if (ImGui::BeginViewportSideBar("##status", ImGui::GetMainViewport(), ImGuiDir_Down, height,
                                    flags)) {
        if (ImGui::BeginMenuBar()) {
            const RenderStatus& s = c.status;
            if (c.ui.paused) ImGui::TextColored(ImVec4(0.91f, 0.64f, 0.24f, 1), "Paused");
            ImGui::TextUnformatted(s.backend.c_str());
            ImGui::TextDisabled("|");
            ImGui::Text("%d x %d", s.width, s.height);
            ImGui::TextDisabled("|");
            ImGui::TextUnformatted(
                fmt::format("{} / {} spp", s.samples, c.document.scene().render.samples).c_str());
            ImGui::TextDisabled("|");
            const double rate = s.samples_per_second;
            ImGui::TextUnformatted(fmt::format("{:.1f} {}samples/s",
                                               rate >= 1e9 ? rate / 1e9 : rate / 1e6,
                                               rate >= 1e9 ? 'G' : 'M')
                                       .c_str());
            ImGui::TextDisabled("|");
            ImGui::Text("%.1f MiB", static_cast<double>(s.memory_bytes) / 1048576);
            draw_jobs(c);
            if (!s.error.empty())
                ImGui::TextColored(ImVec4(1, 0.5f, 0.45f, 1), "%s", s.error.c_str());
            ImGui::EndMenuBar();
        }
    }
    ImGui::End();
}

}  // namespace tp
