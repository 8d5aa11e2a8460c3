// The menus, and the tools beside them.
#include "../actions.h"
#include "../widgets.h"
#include "panels.h"

#include <teapath/editor/scene_edits.h>

#include <fmt/format.h>
#include <icons_font_awesome_6.h>
#include <imgui.h>

namespace tp {
namespace {

void add_shape(PanelContext& c, const ShapeKind& kind) {
    const Camera camera = active_camera(c.document.scene());
    const double size = glm::distance(camera.look_from, camera.look_at) * 0.2;
    ObjectId made;
    c.document.edit(fmt::format("Add {}", kind.label), "",
                    [&](Scene& s) { made = add_object(s, kind, camera.look_at, size); });
    c.document.select(made);
}

void draw_tools(PanelContext& c) {
    ImGui::TextDisabled("|");
    draw_viewport_tools(c);
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
        if (std::string_view(menu) == "Add") {
            for (const ShapeKind& kind : shape_kinds())
                if (ImGui::MenuItem(kind.label)) add_shape(c, kind);
        }
        draw_menu_items(c, menu);
        ImGui::EndMenu();
    }
    draw_tools(c);
    draw_title(c);
    ImGui::EndMainMenuBar();
}

}  // namespace tp
