#include "jobs_view.h"

#include "export_job.h"

#include <fmt/format.h>
#include <icons_font_awesome_6.h>
#include <imgui.h>

#include <algorithm>

namespace tp {
namespace {

void cancel_button(PanelContext& c, const JobView& job) {
    if (job.is_cancelling) {
        ImGui::TextDisabled("stopping");
        return;
    }
    if (!job.can_keep) {
        if (ImGui::SmallButton(ICON_FA_XMARK "##cancel")) c.ui.jobs.cancel(job.id);
        ImGui::SetItemTooltip("Cancel");
        return;
    }
    if (ImGui::SmallButton(ICON_FA_XMARK "##cancel")) ImGui::OpenPopup("cancel");
    ImGui::SetItemTooltip("Stop");
    if (ImGui::BeginPopup("cancel")) {
        if (ImGui::MenuItem("Stop, and save what is there")) c.ui.jobs.cancel(job.id, true);
        if (ImGui::MenuItem("Stop, and keep nothing")) c.ui.jobs.cancel(job.id, false);
        ImGui::EndPopup();
    }
}

}  // namespace

void finish_jobs(PanelContext& c) {
    for (const JobResult& result : c.ui.jobs.take_finished()) {
        if (result.error.empty()) {
            if (result.finish) result.finish(c);
        } else if (result.failed) {
            result.failed(c, result.error);
        } else {
            c.toast(fmt::format("{}: {}", result.title, result.error), true);
        }
    }
}

void draw_jobs(PanelContext& c) {
    for (const JobView& job : c.ui.jobs.running()) {
        // What is done in the blink of an eye is not worth a flash.
        if (job.seconds < 0.3) continue;
        ImGui::PushID(static_cast<int>(job.id));
        ImGui::TextDisabled("|");
        ImGui::TextUnformatted(job.title.c_str());
        const float height = ImGui::GetFontSize();
        const ImVec2 size(height * 6, height * 0.5f);
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() + (ImGui::GetFrameHeight() - size.y) / 2);
        ImGui::ProgressBar(job.share >= 0 ? static_cast<float>(std::min(1.0, job.share))
                                          : -static_cast<float>(ImGui::GetTime()),
                           size, "");
        ImGui::TextDisabled("%s", job.text.c_str());
        cancel_button(c, job);
        ImGui::PopID();
    }
}

}  // namespace tp
