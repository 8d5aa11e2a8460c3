// The parts of the scene panel: one row, and the menu of a row.
#pragma once

#include "../context.h"

#include <imgui.h>

namespace tp {

/// One row of the tree, `height` pixels high: picture or icon, name, eye.
void draw_scene_row(PanelContext& c, const Scene& scene, TreeSection section, size_t index,
                    float height);

/// The ground of a row, lit where it is selected or under the pointer; true in the latter case.
bool tree_row_ground(ImVec2 low, float width, float height, bool is_selected);
/// The part of a row that is clicked; buttons stand beside it, not on it, so that the first click
/// counts wherever it is.
bool tree_row_button(const char* id, float width, float height);

/// Selects as a click on that row does: alone, with Ctrl added or taken away, with Shift the rows
/// from the last one clicked to this one.
void select_by_click(PanelContext& c, TreeSection section, size_t index, bool add, bool range);

/// The menu of rows, inside of a popup.
void scene_row_menu(PanelContext& c, const std::vector<SceneItem>& items);

/// Begins typing a name in place.
void start_rename(PanelContext& c, SceneItem item);

const char* object_icon(const Object& object);

}  // namespace tp
