// Where the panels stand: the built-in layouts, and those that the user saved.
#pragma once

#include "context.h"

namespace tp {

/// Takes a saved layout that was chosen; before ImGui::NewFrame.
void apply_saved_layout(UiState& ui);
/// The dock space, laid out anew where it was asked for or is empty; before the panels are drawn.
void draw_dock_space(PanelContext& c);

/// Asks for a built-in layout: "Edit", "Render" or "Inspect".
void choose_layout(PanelContext& c, const char* name);
/// Items of the menu for the saved layouts.
void draw_saved_layouts(PanelContext& c);

}  // namespace tp
