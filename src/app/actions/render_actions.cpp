// Pause, resume, start again.
#include "../actions.h"

#include <imgui.h>

namespace tp {

std::vector<Action> render_actions() {
    return {
        {.id = "render.pause",
         .menu = "Render",
         .label = "Pause",
         .help = "Holds the picture; an edit still shows at once",
         .keys = {ImGuiKey_P},
         .run = [](PanelContext& c) { c.set_paused(!c.ui.paused); },
         .title = [](const PanelContext& c) -> std::string {
             return c.ui.paused ? "Resume" : "Pause";
         }},
        {.id = "render.restart",
         .menu = "Render",
         .label = "Start again",
         .help = "Throws the samples away and begins anew",
         .run = [](PanelContext& c) { c.worker.restart(); }},
    };
}

}  // namespace tp
