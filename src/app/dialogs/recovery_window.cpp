// What an earlier start lost in a crash, offered once.
#include "dialogs.h"
#include "folder_list.h"

#include <teapath/io/scene_file.h>

#include <fmt/format.h>
#include <imgui.h>

#include <utility>

namespace tp {
namespace {

std::string name_of(const Leftover& leftover) {
    return leftover.original.empty() ? "Untitled" : leftover.original.filename().string();
}

void recover(PanelContext& c, Leftover leftover) {
    JobOptions options;
    options.title = fmt::format("Recovering {}", name_of(leftover));
    options.failed = [leftover](PanelContext& p, const std::string& error) {
        show_message(p.ui, fmt::format("{} cannot be recovered", name_of(leftover)),
                     fmt::format("{}\n\nIt is still in {}", error, leftover.scene.string()));
    };
    c.ui.jobs.start(std::move(options), [leftover](JobControl&) -> JobFinish {
        const auto scene = std::make_shared<Scene>(load_scene(leftover.scene));
        return [leftover, scene](PanelContext& p) {
            ask_first(p, "recovering " + name_of(leftover), [leftover, scene](PanelContext& q) {
                q.document.recover(*scene, leftover.original);
                q.ui.autosave.take_over(leftover);
                q.toast(fmt::format("Recovered {}; save it to keep it", name_of(leftover)));
            });
        };
    });
}

}  // namespace

void draw_recovery_window(PanelContext& c) {
    std::vector<Leftover>& leftovers = c.ui.autosave.leftovers;
    if (leftovers.empty()) return;
    bool is_open = true;
    if (begin_note("Recover unsaved work", &is_open)) {
        ImGui::TextUnformatted("Teapath did not end as it should. These scenes were not saved:");
        ImGui::Spacing();
        size_t decided = leftovers.size();
        bool takes = false;
        if (ImGui::BeginTable("leftovers", 3, ImGuiTableFlags_SizingFixedFit)) {
            for (size_t i = 0; i < leftovers.size(); ++i) {
                ImGui::PushID(static_cast<int>(i));
                ImGui::TableNextRow();
                ImGui::TableNextColumn();
                ImGui::AlignTextToFramePadding();
                ImGui::TextUnformatted(name_of(leftovers[i]).c_str());
                if (!leftovers[i].original.empty())
                    ImGui::SetItemTooltip("%s", leftovers[i].original.c_str());
                ImGui::TableNextColumn();
                ImGui::AlignTextToFramePadding();
                ImGui::TextDisabled("%s", time_text(leftovers[i].time).c_str());
                ImGui::TableNextColumn();
                if (ImGui::Button("Recover")) takes = true, decided = i;
                ImGui::SameLine();
                if (ImGui::Button("Discard")) takes = false, decided = i;
                ImGui::PopID();
            }
            ImGui::EndTable();
        }
        if (decided < leftovers.size()) {
            Leftover leftover = std::move(leftovers[decided]);
            leftovers.erase(leftovers.begin() + static_cast<std::ptrdiff_t>(decided));
            if (takes)
                recover(c, std::move(leftover));
            else
                leftover.discard();
        }
        ImGui::TextDisabled("Your own files are as you saved them.");
    }
    ImGui::End();
    if (!is_open) leftovers.clear();  // offered again at the next start
}

}  // namespace tp
