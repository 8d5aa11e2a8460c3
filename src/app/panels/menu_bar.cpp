// The menus, and the tools beside them.
#include "../actions.h"
#include "../widgets.h"
#include "add_menu.h"
#include "panels.h"

#include <icons_font_awesome_6.h>
#include <imgui.h>

namespace tp {
namespace {

void draw_tools(PanelContext& c) {
    ImGui::TextDisabled("|");
    draw_viewport_tools(c);
    ImGui::TextDisabled("|");
    if (ImGui::MenuItem(c.ui.paused ? ICON_FA_PLAY "##pause" : ICON_FA_PAUSE "##pause"))
        run_action("render.pause", c);
    ui::tooltip("Pause and resume (P)");
}

// The scene's name at the right, as much of it as there is room for.
void draw_title(PanelContext& c) {
    const float room = ImGui::GetWindowWidth() - ImGui::GetCursorPosX() - ui::px(24);
    if (room < ImGui::GetFontSize() * 3) return;
    const std::string title = c.document.title(), shown = ui::fitted(title, room);
    ImGui::SetCursorPosX(ImGui::GetWindowWidth() - ImGui::CalcTextSize(shown.c_str()).x -
                         ui::px(16));
    ImGui::TextUnformatted(shown.c_str());
    ui::tooltip(c.document.file().string().c_str());
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
