// The tools of the viewport as buttons of the menu bar.
#include "../actions.h"
#include "../widgets.h"
#include "panels.h"

#include <fmt/format.h>
#include <icons_font_awesome_6.h>
#include <imgui.h>

namespace tp {
namespace {

// A button that runs an action and is amber while that is checked; the tooltip names its key.
void action_button(PanelContext& c, const char* icon, const char* id) {
    const Action& a = action(id);
    const bool active = a.is_checked && a.is_checked(c);
    if (active) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
    if (ImGui::MenuItem(fmt::format("{}###{}", icon, id).c_str(), nullptr, false, is_enabled(a, c)))
        run_action(id, c);
    if (active) ImGui::PopStyleColor();
    const std::string key = chord_label(c.ui.keys.chords(id)[0]);
    ui::tooltip(
        fmt::format("{}{}\n{}", a.label, key.empty() ? "" : " (" + key + ")", a.help).c_str());
}

void snap_steps(PanelContext& c) {
    if (!ImGui::BeginMenu(ICON_FA_CARET_DOWN "###snap steps")) {
        ui::tooltip("Steps of snapping");
        return;
    }
    ViewportState& v = c.ui.viewport;
    if (ui::begin_rows("steps")) {
        ui::row("Move", v.move_step, 0.1f, 0.01f, 0.001f, 1000.0f, "%.3g", "Scene units");
        ui::row("Rotate", v.rotate_step, 15.0f, 0.5f, 0.1f, 180.0f, "%.1f\xc2\xb0", "Degrees");
        ui::row("Scale", v.scale_step, 0.1f, 0.01f, 0.001f, 10.0f, "%.3g",
                "Of the size at the beginning of the drag");
        ui::end_rows();
    }
    ImGui::EndMenu();
}

}  // namespace

void draw_viewport_tools(PanelContext& c) {
    action_button(c, ICON_FA_ARROW_POINTER, "tool.select");
    action_button(c, ICON_FA_UP_DOWN_LEFT_RIGHT, "tool.move");
    action_button(c, ICON_FA_ROTATE, "tool.rotate");
    action_button(c, ICON_FA_MAXIMIZE, "tool.scale");
    action_button(c, ICON_FA_CROSSHAIRS, "tool.focus");
    action_button(c, ICON_FA_CUBE, "tool.local_axes");
    action_button(c, ICON_FA_MAGNET, "tool.snap");
    snap_steps(c);
}

}  // namespace tp
