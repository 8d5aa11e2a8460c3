// The menus, and the tools beside them.
#include "../actions.h"
#include "../theme.h"
#include "../widgets.h"
#include "add_menu.h"
#include "panels.h"

#include <icons_font_awesome_6.h>
#include <imgui.h>

namespace tp {
namespace {

void tool_button(PanelContext& c, const char* icon, Tool tool, const char* help) {
    Tool& current = c.ui.viewport.tool;
    const bool active = current == tool;
    if (active) ImGui::PushStyleColor(ImGuiCol_Text, to_color(theme().accent_text));
    if (ImGui::MenuItem(icon)) current = tool;
    if (active) ImGui::PopStyleColor();
    ui::tooltip(help);
}

void draw_tools(PanelContext& c) {
    ImGui::TextDisabled("|");
    tool_button(c, ICON_FA_ARROW_POINTER "##select", Tool::Select, "Select");
    tool_button(c, ICON_FA_UP_DOWN_LEFT_RIGHT "##move", Tool::Move, "Move the selection");
    tool_button(c, ICON_FA_ROTATE "##rotate", Tool::Rotate, "Rotate the selection");
    tool_button(c, ICON_FA_MAXIMIZE "##scale", Tool::Scale, "Scale the selection");
    ImGui::TextDisabled("|");
    if (ImGui::MenuItem(c.ui.paused ? ICON_FA_PLAY "##pause" : ICON_FA_PAUSE "##pause"))
        run_action("render.pause", c);
    ui::tooltip("Pause and resume (P)");
}

void draw_title(PanelContext& c) {
    const std::string title = c.document.title();
    ImGui::SetCursorPosX(ImGui::GetWindowWidth() - ImGui::CalcTextSize(title.c_str()).x - 16);
    ImGui::TextUnformatted(title.c_str());
}

}  // namespace

void draw_menu_bar(PanelContext& c) {
    if (!ImGui::BeginMainMenuBar()) return;
    for (const char* menu : {"File", "Edit", "Add", "View", "Render", "Help"}) {
        if (!ImGui::BeginMenu(menu)) continue;
        if (std::string_view(menu) == "Add") add_menu_items(c);
        draw_menu_items(c, menu);
        ImGui::EndMenu();
    }
    draw_tools(c);
    draw_title(c);
    ImGui::EndMainMenuBar();
}

}  // namespace tp
