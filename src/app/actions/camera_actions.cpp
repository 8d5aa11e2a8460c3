// The keys of flying, the jumps of the camera, and its bookmarks.
#include "../actions.h"
#include "../fly_camera.h"
#include "../viewport/bookmarks.h"
#include "../viewport/scene_extent.h"

#include <teapath/editor/scene_edits.h>

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <utility>

namespace tp {
namespace {

void frame_extent(PanelContext& c, const std::optional<Extent>& extent) {
    if (!extent) return;
    const ViewportState& v = c.ui.viewport;
    const Camera camera = frame(active_camera(c.document.scene()), extent->center, extent->radius,
                                static_cast<double>(v.width) / v.height);
    c.document.edit("Frame", "", [&](Scene& s) {
        if (Camera* target = find_camera(s, camera.id)) *target = camera;
    });
}

void frame_selection(PanelContext& c) {
    frame_extent(c, extent_of(selected_objects(c.document.scene(), c.document.selection)));
}

void frame_all(PanelContext& c) {
    frame_extent(c, extent_of_all(c.document.scene()));
}

void reset_camera(PanelContext& c) {
    const Camera start = active_camera(*c.document.history().front().scene);
    c.document.edit("Reset camera", "", [&](Scene& s) {
        if (Camera* target = find_camera(s, start.id)) *target = start;
    });
}

constexpr const char* kHeldHelp = "While the key is down, in the viewport";

Action held(const char* id, const char* label, int key, int other = 0,
            const char* help = kHeldHelp) {
    return {.id = id,
            .menu = "",
            .label = label,
            .help = help,
            .keys = {key, other},
            .scope = ActionScope::Held};
}

template <int kNumber>
void set_bookmark_number(PanelContext& c) {
    c.document.edit(fmt::format("Set bookmark {}", kNumber), "",
                    [](Scene& s) { set_bookmark(s, kNumber); });
    c.toast(fmt::format("Bookmark {} set", kNumber));
}

template <int kNumber>
void go_to_bookmark_number(PanelContext& c) {
    c.document.edit(fmt::format("Go to bookmark {}", kNumber), "",
                    [](Scene& s) { go_to_bookmark(s, kNumber); });
}

// "camera.bookmark_1" and "camera.set_bookmark_1" up to 9.
template <int kNumber>
void add_bookmark(std::vector<Action>& table) {
    static const std::array<std::string, 4> text = {
        fmt::format("camera.bookmark_{}", kNumber), fmt::format("Go to bookmark {}", kNumber),
        fmt::format("camera.set_bookmark_{}", kNumber), fmt::format("Set bookmark {}", kNumber)};
    table.push_back({.id = text[0].c_str(),
                     .menu = "View/Bookmarks",
                     .label = text[1].c_str(),
                     .help = "Looks from where the bookmark was set",
                     .keys = {ImGuiKey_0 + kNumber},
                     .scope = ActionScope::Viewport,
                     .run = go_to_bookmark_number<kNumber>,
                     .is_enabled = [](const PanelContext& c) {
                         return find_bookmark(c.document.scene(), kNumber) != nullptr;
                     }});
    table.push_back({.id = text[2].c_str(),
                     .menu = "View/Bookmarks",
                     .label = text[3].c_str(),
                     .help = "Keeps this view in the scene, as a camera of that name",
                     .keys = {ImGuiMod_Ctrl | (ImGuiKey_0 + kNumber)},
                     .run = set_bookmark_number<kNumber>});
}

template <int... kNumbers>
void add_bookmarks(std::vector<Action>& table, std::integer_sequence<int, kNumbers...>) {
    (add_bookmark<kNumbers + 1>(table), ...);
}

}  // namespace

std::vector<Action> camera_actions() {
    std::vector<Action> table = {
        held("fly.forward", "Fly forward", ImGuiKey_W),
        held("fly.back", "Fly back", ImGuiKey_S),
        held("fly.left", "Fly left", ImGuiKey_A),
        held("fly.right", "Fly right", ImGuiKey_D),
        held("fly.up", "Fly up", ImGuiKey_E, ImGuiKey_Space),
        held("fly.down", "Fly down", ImGuiKey_Q, ImGuiKey_LeftCtrl,
             "Left Ctrl alone after 0.15 s, at once while the right button is held"),
        held("fly.faster", "Fly faster", ImGuiKey_LeftShift, 0,
             "Four times as fast while it is down"),
        {.id = "camera.frame_selection",
         .menu = "View",
         .label = "Frame selection",
         .help = "Moves the camera so that the selected objects fill the view",
         .keys = {ImGuiKey_F},
         .scope = ActionScope::Viewport,
         .run = frame_selection,
         .is_enabled = [](const PanelContext& c) { return !c.document.selection.empty(); },
         .starts_group = true},
        {.id = "camera.frame_all",
         .menu = "View",
         .label = "Frame all",
         .help = "Moves the camera so that everything but the ground fills the view",
         .keys = {ImGuiKey_Home},
         .scope = ActionScope::Viewport,
         .run = frame_all},
        {.id = "camera.reset",
         .menu = "View",
         .label = "Reset camera",
         .help = "Position, direction and field of view as in the file",
         .keys = {ImGuiKey_C},
         .scope = ActionScope::Viewport,
         .run = reset_camera},
    };
    add_bookmarks(table, std::make_integer_sequence<int, 9>{});
    return table;
}

}  // namespace tp
