// The undo list; a click goes there.
#include "panels.h"

#include <imgui.h>

namespace tp {

void draw_history(PanelContext& c) {
    if (begin_panel(c, "History")) {
        for (size_t i = 0; i < c.document.history().size(); ++i) {
            const bool is_undone = i > c.document.history_position();
            if (is_undone)
                ImGui::PushStyleColor(ImGuiCol_Text,
                                      ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
            ImGui::PushID(static_cast<int>(i));
            const std::string label = c.document.history()[i].label;
            if (ImGui::Selectable(label.c_str(), i == c.document.history_position()))
                c.document.go_to(i);
            ImGui::PopID();
            if (is_undone) ImGui::PopStyleColor();
        }
    }
    ImGui::End();
}

}  // namespace tp
