// The name for a layout that is to be saved.
#include "../layout_file.h"
#include "../widgets.h"
#include "dialogs.h"

#include <teapath/core/error.h>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace tp {
namespace {

void save(PanelContext& c) {
    try {
        save_layout(configuration_folder() / "layouts",
                    {c.ui.dialogs.layout_name, c.ui.preferences.closed_panels,
                     ImGui::SaveIniSettingsToMemory()});
        c.toast(fmt::format("Saved the layout {}", c.ui.dialogs.layout_name));
    } catch (const Error& error) {
        c.toast(error.what(), true);
    }
    c.ui.layout.is_stale = true;
}

}  // namespace

void draw_save_layout_window(PanelContext& c) {
    if (!c.ui.dialogs.show_save_layout || !begin_question("Save the layout")) return;
    ImGui::TextUnformatted("Name");
    ImGui::SameLine();
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 14);
    bool saves =
        ImGui::InputText("##name", &c.ui.dialogs.layout_name, ImGuiInputTextFlags_EnterReturnsTrue);
    const std::string why = why_no_layout_name(c.ui.dialogs.layout_name);
    ImGui::Spacing();
    saves |= ui::button("Save", why.empty(), why.c_str());
    ImGui::SameLine();
    const bool gives_up = ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGuiKey_Escape);
    saves = saves && why.empty();
    if (saves) save(c);
    if (saves || gives_up) {
        c.ui.dialogs.show_save_layout = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace tp
