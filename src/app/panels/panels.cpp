#include "panels.h"

#include <imgui.h>

namespace tp {

const std::vector<Panel>& panels() {
    static const std::vector<Panel> table = {
        {"Viewport", draw_viewport},   {"Options", draw_options}, {"Scene", draw_scene_tree},
        {"Inspector", draw_inspector}, {"Console", draw_console}, {"Metrics", draw_metrics},
        {"History", draw_history}};
    return table;
}

bool begin_panel(PanelContext& c, const char* title, int flags) {
    bool is_open = true;
    // At the start the tabs that were in front stay there: no panel asks for the focus.
    flags |= ImGuiWindowFlags_NoFocusOnAppearing;
    const bool is_shown = ImGui::Begin(title, &is_open, flags);
    if (!is_open) c.ui.preferences.set_panel_open(title, false);
    return is_shown;
}

void draw_open_panels(PanelContext& c) {
    for (const Panel& panel : panels())
        if (c.ui.preferences.is_panel_open(panel.title)) panel.draw(c);
    // What is not drawn does not take the keys.
    if (!c.ui.preferences.is_panel_open("Viewport"))
        c.ui.viewport.has_focus = c.ui.viewport.is_moving = c.ui.viewport.is_looking = false;
}

}  // namespace tp
