// Scenes and pictures to and from files, and the end.
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
         .run =
             [](PanelContext& c) {
                 ask_first(c, "starting a new scene", [](PanelContext& p) {
                     p.document.start_new();
                     p.ui.viewport.fly_speed = 0;
                 });
             }},
        {.id = "file.open",
         .menu = "File",
         .label = "Open\xe2\x80\xa6",
         .help = "Opens a scene file; dropping one on the window does the same",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_O},
         .run = [](PanelContext& c) { ask_first(c, "opening another scene", ask_to_open); }},
        {.id = "file.recent",
         .menu = "File/Open recent",
         .label = "Open recent",
         .help = "",
         .more = draw_recent_files},
        {.id = "file.save",
         .menu = "File",
         .label = "Save",
         .help = "Writes the scene to its file",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_S},
         .run = [](PanelContext& c) { save_scene_or_ask(c); },
         .starts_group = true},
        {.id = "file.save_as",
         .menu = "File",
         .label = "Save as\xe2\x80\xa6",
         .help = "Writes the scene to another file",
         .keys = {ImGuiMod_Ctrl | ImGuiMod_Shift | ImGuiKey_S},
         .run = [](PanelContext& c) { ask_to_save_as(c); }},
        {.id = "file.save_image",
         .menu = "File",
         .label = "Save image\xe2\x80\xa6",
         .help = "Writes the picture as it is now: PNG, JPEG, or HDR and EXR with linear radiance",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_E},
         .run = ask_to_save_image,
         .starts_group = true},
        {.id = "file.save_window",
         .menu = "File",
         .label = "Save window as image\xe2\x80\xa6",
         .help = "Writes the picture with the interface around it",
         .run = ask_to_save_window},
        {.id = "file.copy_image",
         .menu = "File",
         .label = "Copy image",
         .help = "Puts the picture into the clipboard",
         .keys = {ImGuiMod_Ctrl | ImGuiMod_Shift | ImGuiKey_C},
         .run = copy_image,
         .is_enabled = [](const PanelContext&) { return why_not_copied().empty(); },
         .why_not = [](const PanelContext&) { return why_not_copied(); }},
        {.id = "file.export",
         .menu = "File",
         .label = "Export\xe2\x80\xa6",
         .help = "Renders a picture or frames to files while you go on working",
         .keys = {ImGuiMod_Ctrl | ImGuiMod_Shift | ImGuiKey_E},
         .run = [](PanelContext& c) { c.ui.dialogs.show_export = true; }},
        {.id = "file.quit",
         .menu = "File",
         .label = "Quit",
         .help = "Asks first if something is not saved",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_Q},
         .run = ask_to_quit,
         .starts_group = true},
    };
}

}  // namespace tp
