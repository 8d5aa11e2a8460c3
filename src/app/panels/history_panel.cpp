// The undo list; a click goes there.
#include "../theme.h"
#include "../widgets.h"
#include "panels.h"

#include <icons_font_awesome_6.h>
#include <imgui.h>

namespace tp {
namespace {

void draw_step(PanelContext& c, size_t i, bool is_saved) {
    const size_t position = c.document.history_position();
    const bool is_current = i == position, is_undone = i > position;
    ImGui::PushID(static_cast<int>(i));
    ImGui::PushStyleColor(ImGuiCol_Text, to_color(is_undone ? theme().dim : theme().text));
    const float width = ImGui::GetContentRegionAvail().x, mark = ImGui::GetFontSize() * 1.5f;
    const std::string label = ui::fitted(c.document.history()[i].label, width - mark);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable((label + "###step").c_str(), is_current)) c.document.go_to(i);
    ImGui::PopStyleColor();
    if (is_saved) {
        ImGui::GetWindowDrawList()->AddText({low.x + width - mark, low.y},
                                            ImGui::GetColorU32(ImGuiCol_TextDisabled),
                                            ICON_FA_FLOPPY_DISK);
        ImGui::SetItemTooltip("What the file holds");
    }
    ImGui::PopID();
}

// Where the list was scrolled to last.
struct ShownPosition {
    size_t value = 0;
};

}  // namespace

void draw_history(PanelContext& c) {
    if (begin_panel(c, "History")) {
        size_t& shown = c.ui.local.get<ShownPosition>().value;
        const size_t count = c.document.history().size(), position = c.document.history_position(),
                     saved = c.document.history_saved();
        if (ImGui::BeginChild("steps")) {
            for (size_t i = 0; i < c.document.history().size(); ++i) {
                draw_step(c, i, i == saved);
                if (i == position && shown != position + count) ImGui::SetScrollHereY(0.5f);
            }
            shown = position + count;
        }
        ImGui::EndChild();
    }
    ImGui::End();
}

}  // namespace tp
