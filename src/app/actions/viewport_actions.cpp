// The tools of the viewport, the selection in it, and how large the picture is shown.
#include "../actions.h"
#include "../viewport/picture_place.h"

#include <imgui.h>

namespace tp {
namespace {

template <Tool kTool>
Action tool(const char* id, const char* label, const char* help, int key) {
    return {.id = id,
            .menu = "Edit/Tools",
            .label = label,
            .help = help,
            .keys = {key},
            .scope = ActionScope::Viewport,
            .run = [](PanelContext& c) { c.ui.viewport.tool = kTool; },
            .is_checked = [](const PanelContext& c) { return c.ui.viewport.tool == kTool; }};
}

// Esc: one thing at a time, the pointer first.
void let_go(PanelContext& c) {
    if (!release_pointer(c.ui.viewport.navigation)) c.document.select(ObjectId{});
}

void zoom_by(PanelContext& c, double factor) {
    ViewportState& v = c.ui.viewport;
    v.view = zoomed(v.view, factor, {0, 0}, v.panel_size, v.picture_pixels);
}

}  // namespace

std::vector<Action> viewport_actions() {
    return {
        {.id = "edit.deselect",
         .menu = "Edit",
         .label = "Deselect",
         .help = "Gives the pointer free, or else selects nothing",
         .keys = {ImGuiKey_Escape},
         .scope = ActionScope::Viewport,
         .run = let_go},
        tool<Tool::Select>("tool.select", "Select", "Click selects, Shift adds", ImGuiKey_V),
        tool<Tool::Move>("tool.move", "Move", "Handles that move the selection", ImGuiKey_G),
        tool<Tool::Rotate>("tool.rotate", "Rotate", "Handles that turn the selection", ImGuiKey_R),
        tool<Tool::Scale>("tool.scale", "Scale", "Handles that scale the selection", ImGuiKey_T),
        tool<Tool::Focus>("tool.focus", "Focus",
                          "Click sets the distance that is sharp; Ctrl+Alt+click does it at once",
                          ImGuiKey_O),
        {.id = "tool.local_axes",
         .menu = "Edit/Tools",
         .label = "Axes of the object",
         .help = "Handles along the axes of the active object instead of the world's",
         .keys = {ImGuiKey_X},
         .scope = ActionScope::Viewport,
         .run = [](PanelContext& c) { c.ui.viewport.local_axes = !c.ui.viewport.local_axes; },
         .is_checked = [](const PanelContext& c) { return c.ui.viewport.local_axes; },
         .starts_group = true},
        {.id = "tool.snap",
         .menu = "Edit/Tools",
         .label = "Snap",
         .help = "Handles go in steps; Ctrl turns it round for one drag",
         .keys = {ImGuiKey_M},
         .scope = ActionScope::Viewport,
         .run = [](PanelContext& c) { c.ui.viewport.snap = !c.ui.viewport.snap; },
         .is_checked = [](const PanelContext& c) { return c.ui.viewport.snap; }},
        {.id = "edit.settings",
         .menu = "Edit",
         .label = "Settings\xe2\x80\xa6",
         .help = "Interface, flying, saving, and every key",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_Comma},
         .run = [](PanelContext& c) { c.ui.dialogs.show_settings = true; },
         .starts_group = true},
        {.id = "view.fixed_size",
         .menu = "View/Picture",
         .label = "Size of the scene file",
         .help = "Renders the size that the scene file has instead of the panel's",
         .run =
             [](PanelContext& c) {
                 c.ui.viewport.fixed_size = !c.ui.viewport.fixed_size;
                 c.ui.viewport.view = {};
             },
         .is_checked = [](const PanelContext& c) { return c.ui.viewport.fixed_size; }},
        {.id = "view.smooth_picture",
         .menu = "View/Picture",
         .label = "Smooth pixels",
         .help = "Interpolates between the pixels of a picture that is shown larger or smaller",
         .run =
             [](PanelContext& c) {
                 bool& smooth = c.ui.preferences.smooth_picture;
                 smooth = !smooth;
             },
         .is_checked = [](const PanelContext& c) { return c.ui.preferences.smooth_picture; }},
        {.id = "view.ground_grid",
         .menu = "View/Picture",
         .label = "Ground grid",
         .help = "Lines on the plane y = 0 over the picture, a power of ten apart",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_G},
         .run =
             [](PanelContext& c) { c.ui.preferences.ground_grid = !c.ui.preferences.ground_grid; },
         .is_checked = [](const PanelContext& c) { return c.ui.preferences.ground_grid; }},
        {.id = "view.zoom_fit",
         .menu = "View/Picture",
         .label = "Fit",
         .help = "As large as the panel allows",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_0},
         .run = [](PanelContext& c) { c.ui.viewport.view = {}; },
         .starts_group = true},
        {.id = "view.zoom_actual",
         .menu = "View/Picture",
         .label = "Actual pixels",
         .help = "A pixel of the picture on each pixel of the screen",
         .keys = {ImGuiMod_Ctrl | ImGuiMod_Alt | ImGuiKey_0},
         .run =
             [](PanelContext& c) {
                 c.ui.viewport.view = {1, {0, 0}};
             }},
        {.id = "view.zoom_in",
         .menu = "View/Picture",
         .label = "Zoom in",
         .help = "Shows the picture larger; Shift and the wheel do so at the pointer",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_Equal, ImGuiMod_Ctrl | ImGuiKey_KeypadAdd},
         .run = [](PanelContext& c) { zoom_by(c, 2); }},
        {.id = "view.zoom_out",
         .menu = "View/Picture",
         .label = "Zoom out",
         .help = "Shows the picture smaller; Shift and the middle button move it",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_Minus, ImGuiMod_Ctrl | ImGuiKey_KeypadSubtract},
         .run = [](PanelContext& c) { zoom_by(c, 0.5); }},
    };
}

}  // namespace tp
