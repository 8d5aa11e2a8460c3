// New, open, save, save the image, quit.
#include "../actions.h"
#include "../dialogs/dialogs.h"

#include <imgui.h>

namespace tp {

std::vector<Action> file_actions() {
    return {
        {.id = "file.new",
         .menu = "File",
         .label = "New",
         .help = "A floor, a sky and a camera to begin with",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_N},
         .run = [](PanelContext& c) { ask_first(c, "new"); }},
        {.id = "file.open",
         .menu = "File",
         .label = "Open\xe2\x80\xa6",
         .help = "Opens a scene file; dropping one on the window does the same",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_O},
         .run = [](PanelContext& c) { ask_first(c, "open"); }},
        {.id = "file.save",
         .menu = "File",
         .label = "Save",
         .help = "Writes the scene to its file",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_S},
         .run = [](PanelContext& c) { save_scene_or_ask(c); }},
        {.id = "file.save_as",
         .menu = "File",
         .label = "Save as\xe2\x80\xa6",
         .help = "Writes the scene to another file",
         .keys = {ImGuiMod_Ctrl | ImGuiMod_Shift | ImGuiKey_S},
         .run = [](PanelContext& c) { c.ui.dialogs.show_save_as = true; }},
        {.id = "file.save_image",
         .menu = "File",
         .label = "Save image\xe2\x80\xa6",
         .help = "Writes what the viewport shows to an image file",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_E},
         .run = [](PanelContext& c) { c.ui.dialogs.show_export = true; },
         .starts_group = true},
        {.id = "file.quit",
         .menu = "File",
         .label = "Quit",
         .help = "Asks first if something is not saved",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_Q},
         .run = [](PanelContext& c) { ask_first(c, "quit"); },
         .starts_group = true},
    };
}

}  // namespace tp
