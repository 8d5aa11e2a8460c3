// Help.
#include "../actions.h"

#include <imgui.h>

namespace tp {

std::vector<Action> help_actions() {
    return {
        {.id = "help.keys",
         .menu = "Help",
         .label = "Keys",
         .help = "What every key does",
         .keys = {ImGuiKey_F1},
         .run = [](PanelContext& c) { c.ui.dialogs.show_keys = !c.ui.dialogs.show_keys; },
         .is_checked = [](const PanelContext& c) { return c.ui.dialogs.show_keys; }},
    };
}

}  // namespace tp
