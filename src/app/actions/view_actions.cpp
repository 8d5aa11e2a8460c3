// How the window looks.
#include "../actions.h"
#include "../theme.h"

#include <imgui.h>

namespace tp {
namespace {

void toggle_theme(PanelContext& c) {
    bool& dark = c.ui.preferences.dark_theme;
    dark = !dark;
    apply_theme(dark, c.window.scale());
}

}  // namespace

std::vector<Action> view_actions() {
    return {
        {.id = "view.reset_layout",
         .menu = "View",
         .label = "Reset layout",
         .help = "Puts every panel where it was at first",
         .run = [](PanelContext& c) { c.ui.reset_layout = true; }},
        {.id = "view.full_screen",
         .menu = "View",
         .label = "Full screen",
         .help = "On the monitor that the window is on",
         .keys = {ImGuiKey_F11},
         .run = [](PanelContext& c) { c.window.toggle_full_screen(); }},
        {.id = "view.light_theme",
         .menu = "View",
         .label = "Light theme",
         .help = "Light panels instead of dark ones",
         .run = toggle_theme,
         .is_checked = [](const PanelContext& c) { return !c.ui.preferences.dark_theme; }},
    };
}

}  // namespace tp
