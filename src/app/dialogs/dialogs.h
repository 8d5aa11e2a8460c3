// The windows that ask something, and what they lead to.
#pragma once

#include "../context.h"

namespace tp {

/// Draws the dialogs that are open.
void draw_dialogs(PanelContext& c);

/// Opens a scene file; a broken one is a notice, and the old scene stays.
void open_scene(PanelContext& c, const std::filesystem::path& file);
/// Saves under the document's name, or asks for one.
void save_scene_or_ask(PanelContext& c);
/// Does `what` ("quit", "new", "open") at once, or after the question about unsaved changes.
void ask_first(PanelContext& c, const std::string& what);

/// The table of keys, from the action table.
void draw_keys_window(PanelContext& c);

/// The user's settings; what they say of theme and scale is put in force here in any case.
void draw_settings_window(PanelContext& c);

}  // namespace tp
