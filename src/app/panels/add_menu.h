// Everything that can be added to a scene: the Add menu, and its parts in the tree.
#pragma once

#include "../context.h"

#include <teapath/editor/scene_edits.h>

namespace tp {

/// The items of the whole Add menu.
void add_menu_items(PanelContext& c);

// Its parts; what is added is selected.
void add_object_items(PanelContext& c);
void add_light_items(PanelContext& c);
void add_camera(PanelContext& c);
void add_material_items(PanelContext& c);
void add_texture_items(PanelContext& c);

}  // namespace tp
