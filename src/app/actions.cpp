#include "actions.h"

#include <imgui.h>

#include <algorithm>
#include <stdexcept>

namespace tp {
namespace {

std::vector<Action> make_table() {
    std::vector<Action> table;
    for (const auto& part : {file_actions(), edit_actions(), view_actions(), camera_actions(),
                             render_actions(), help_actions()})
        table.insert(table.end(), part.begin(), part.end());
    return table;
}

// A chord without Ctrl or Alt is part of what is typed into a field.
bool is_typed(int chord) {
    return (chord & (ImGuiMod_Ctrl | ImGuiMod_Alt)) == 0;
}

bool is_pressed(int chord, const PanelContext& c) {
    if (chord == 0) return false;
    if (is_typed(chord) && ImGui::GetIO().WantTextInput) return false;
    // While the right button is held, keys fly.
    if (c.ui.viewport.is_looking && is_typed(chord) && c.ui.keys.flies(chord)) return false;
    return ImGui::IsKeyChordPressed(chord);
}

}  // namespace

const std::vector<Action>& actions() {
    static const std::vector<Action> table = make_table();
    return table;
}

const Action& action(std::string_view id) {
    const auto found = std::find_if(actions().begin(), actions().end(),
                                    [&](const Action& a) { return a.id == id; });
    if (found == actions().end()) throw std::out_of_range("no action " + std::string(id));
    return *found;
}

bool is_enabled(const Action& action, const PanelContext& c) {
    return !action.is_enabled || action.is_enabled(c);
}

void run_action(std::string_view id, PanelContext& c) {
    const Action& a = action(id);
    if (a.run && is_enabled(a, c)) a.run(c);
}

void run_shortcuts(PanelContext& c) {
    // A modal dialog has the keys for itself.
    if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        return;
    for (const Action& a : actions()) {
        if (!a.run || a.scope == ActionScope::Held) continue;
        if (a.scope == ActionScope::Viewport && !c.ui.viewport.has_focus) continue;
        const KeyMap::Chords chords = c.ui.keys.chords(a.id);
        if (std::any_of(chords.begin(), chords.end(), [&](int k) { return is_pressed(k, c); }) &&
            is_enabled(a, c))
            a.run(c);
    }
}

bool is_held(std::string_view id, const PanelContext& c) {
    for (const int chord : c.ui.keys.chords(id))
        if (chord != 0 && ImGui::IsKeyDown(static_cast<ImGuiKey>(chord & ~ImGuiMod_Mask_)))
            return true;
    return false;
}

void draw_menu_items(PanelContext& c, std::string_view menu) {
    for (const Action& a : actions()) {
        if (a.menu != menu || !(a.run || a.submenu)) continue;
        if (a.starts_group) ImGui::Separator();
        if (a.submenu) {
            if (ImGui::BeginMenu(a.label, is_enabled(a, c))) {
                a.submenu(c);
                ImGui::EndMenu();
            }
            continue;
        }
        const std::string title = (a.title ? a.title(c) : a.label) + "###" + a.id;
        const std::string key = chord_name(c.ui.keys.chords(a.id)[0]);
        if (ImGui::MenuItem(title.c_str(), key.c_str(), a.is_checked && a.is_checked(c),
                            is_enabled(a, c)))
            a.run(c);
        const bool is_greyed = a.why_not && !is_enabled(a, c);
        const std::string tip = is_greyed ? a.why_not(c) : a.help;
        if (!tip.empty() && ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip |
                                                 ImGuiHoveredFlags_AllowWhenDisabled))
            ImGui::SetTooltip("%s", tip.c_str());
    }
}

}  // namespace tp
