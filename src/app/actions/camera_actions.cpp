// The keys of flying, and the jumps of the camera.
#include "../actions.h"
#include "../fly_camera.h"

#include <teapath/editor/scene_edits.h>

#include <imgui.h>

namespace tp {
namespace {

void frame_objects(PanelContext& c, bool all) {
    Double3 low(1e30), high(-1e30);
    for (const Object& o : c.document.scene().objects) {
        if (!all && !c.document.is_selected(o.id)) continue;
        const Extent e = extent_of(o);
        if (all && e.radius > 50) continue;  // the ground would hide the rest
        low = glm::min(low, e.center - e.radius);
        high = glm::max(high, e.center + e.radius);
    }
    if (low.x > high.x) return;
    const Camera camera =
        frame(active_camera(c.document.scene()), (low + high) * 0.5, glm::distance(low, high) / 2);
    c.document.edit("Frame", "", [&](Scene& s) {
        if (Camera* target = find_camera(s, camera.id)) *target = camera;
    });
}

void reset_camera(PanelContext& c) {
    const Camera start = active_camera(*c.document.history().front().scene);
    c.document.edit("Reset camera", "", [&](Scene& s) {
        if (Camera* target = find_camera(s, start.id)) *target = start;
    });
}

Action held(const char* id, const char* label, int key, int other = 0) {
    return {.id = id,
            .menu = "",
            .label = label,
            .help = "While the key is down, in the viewport",
            .keys = {key, other},
            .scope = ActionScope::Held};
}

}  // namespace

std::vector<Action> camera_actions() {
    return {
        held("fly.forward", "Fly forward", ImGuiKey_W),
        held("fly.back", "Fly back", ImGuiKey_S),
        held("fly.left", "Fly left", ImGuiKey_A),
        held("fly.right", "Fly right", ImGuiKey_D),
        held("fly.up", "Fly up", ImGuiKey_E, ImGuiKey_Space),
        held("fly.down", "Fly down", ImGuiKey_Q, ImGuiKey_LeftCtrl),
        held("fly.faster", "Fly faster", ImGuiKey_LeftShift),
        {.id = "camera.frame_selection",
         .menu = "View",
         .label = "Frame selection",
         .help = "Moves the camera so that the selected objects fill the view",
         .keys = {ImGuiKey_F},
         .scope = ActionScope::Viewport,
         .run = [](PanelContext& c) { frame_objects(c, false); },
         .is_enabled = [](const PanelContext& c) { return !c.document.selection.empty(); },
         .starts_group = true},
        {.id = "camera.frame_all",
         .menu = "View",
         .label = "Frame all",
         .help = "Moves the camera so that everything but the ground fills the view",
         .keys = {ImGuiKey_Home},
         .scope = ActionScope::Viewport,
         .run = [](PanelContext& c) { frame_objects(c, true); }},
        {.id = "camera.reset",
         .menu = "View",
         .label = "Reset camera",
         .help = "Position and direction as in the file",
         .keys = {ImGuiKey_C},
         .scope = ActionScope::Viewport,
         .run = reset_camera},
    };
}

}  // namespace tp
