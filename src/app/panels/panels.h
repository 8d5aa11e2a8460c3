// The panels of the window: one table, one function each. Panels hold no copy of a scene value.
#pragma once

#include "../context.h"

#include <vector>

namespace tp {

struct Panel {
    const char* title;
    void (*draw)(PanelContext&);
};
/// All panels that can be closed and docked; the View menu, the layouts and the tests read this.
const std::vector<Panel>& panels();

/// ImGui::Begin of a panel, with the cross that closes it. ImGui::End follows always.
bool begin_panel(PanelContext& c, const char* title, int flags = 0);

/// Draws the panels that are open.
void draw_open_panels(PanelContext& c);

void draw_menu_bar(PanelContext& c);
void draw_viewport(PanelContext& c);
/// The tools of the viewport, as items of a menu bar.
void draw_viewport_tools(PanelContext& c);
void draw_options(PanelContext& c);
void draw_scene_tree(PanelContext& c);
void draw_inspector(PanelContext& c);
void draw_metrics(PanelContext& c);
void draw_console(PanelContext& c);
void draw_history(PanelContext& c);
void draw_status_bar(PanelContext& c);

}  // namespace tp
