// The panels of the window: one function each. Panels hold no copy of a scene value.
#pragma once

#include "../context.h"

namespace tp {

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
