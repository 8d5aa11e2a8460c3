#include "actions.h"

#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace tp {
namespace {

std::vector<Action> make_table() {
    std::vector<Action> table;
    for (const auto& part : {file_actions(), edit_actions(), view_actions(), camera_actions(),
                             viewport_actions(), render_actions(), help_actions()})
        table.insert(table.end(), part.begin(), part.end());
    return table;
}

// A chord without Ctrl or Alt is part of what is typed into a field.
bool is_typed(int chord) {
    return (chord & (ImGuiMod_Ctrl | ImGuiMod_Alt)) == 0;
}

// A chord that means something in a text field: mark, copy, undo, go by words.
bool edits_text(int chord) {
    constexpr int kKeys[] = {ImGuiKey_A,          ImGuiKey_C,      ImGuiKey_V,
                             ImGuiKey_X,          ImGuiKey_Y,      ImGuiKey_Z,
                             ImGuiKey_Home,       ImGuiKey_End,    ImGuiKey_LeftArrow,
                             ImGuiKey_RightArrow, ImGuiKey_Delete, ImGuiKey_Backspace};
    return std::find(std::begin(kKeys), std::end(kKeys), chord & ~ImGuiMod_Mask_) !=
           std::end(kKeys);
}

bool is_pressed(int chord, const PanelContext& c) {
    if (chord == 0) return false;
    if (ImGui::GetIO().WantTextInput && (is_typed(chord) || edits_text(chord))) return false;
    // While the right button is held, keys fly.
    if (c.ui.viewport.is_looking && is_typed(chord) && c.ui.keys.flies(chord)) return false;
    return ImGui::IsKeyChordPressed(chord);
}

void perform(const Action& a, PanelContext& c) {
    c.ui.last_action = a.id;
    a.run(c);
}

void draw_item(PanelContext& c, const Action& a) {
    if (a.starts_group) ImGui::Separator();
    if (a.more) {
        a.more(c);
        return;
    }
    const std::string title = (a.title ? a.title(c) : a.label) + "###" + a.id;
    const std::string key = chord_label(c.ui.keys.chords(a.id)[0]);
    if (ImGui::MenuItem(title.c_str(), key.c_str(), a.is_checked && a.is_checked(c),
                        is_enabled(a, c)))
        perform(a, c);
    const bool is_greyed = a.why_not && !is_enabled(a, c);
    const std::string tip = is_greyed ? a.why_not(c) : a.help;
    if (!tip.empty() &&
        ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip | ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("%s", tip.c_str());
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
    if (a.run && is_enabled(a, c)) perform(a, c);
}

void run_shortcuts(PanelContext& c) {
    // A modal dialog has the keys for itself.
    if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        return;
    // The settings wait for a key, or have just got it.
    const bool was_taken = std::exchange(c.ui.dialogs.key_was_taken, false);
    if (was_taken || !c.ui.dialogs.key_to_set.empty()) return;
    for (const Action& a : actions()) {
        if (!a.run || a.scope == ActionScope::Held) continue;
        if (a.scope == ActionScope::Viewport && !c.ui.viewport.has_focus) continue;
        const KeyMap::Chords chords = c.ui.keys.chords(a.id);
        if (std::any_of(chords.begin(), chords.end(), [&](int k) { return is_pressed(k, c); }) &&
            is_enabled(a, c))
            perform(a, c);
    }
}

void draw_menu_items(PanelContext& c, std::string_view menu) {
    const std::string below = std::string(menu) + '/';
    std::string submenu;  // the one that is being drawn
    bool is_open = false;
    const auto end_submenu = [&] {
        if (is_open) ImGui::EndMenu();
        is_open = false;
        submenu.clear();
    };
    for (const Action& a : actions()) {
        if (!a.run && !a.more) continue;
        const std::string_view where = a.menu;
        const bool is_below = where.substr(0, below.size()) == below;
        if (where != menu && !is_below) continue;
        if (submenu != (is_below ? where.substr(below.size()) : "")) {
            end_submenu();
            if (is_below) {
                submenu = where.substr(below.size());
                is_open = ImGui::BeginMenu(submenu.c_str());
            }
        }
        if (is_below && !is_open) continue;
        draw_item(c, a);
    }
    end_submenu();
}

std::string group_of(const Action& action) {
    if (action.scope == ActionScope::Held) return "Fly";
    const std::string_view menu = action.menu;
    const size_t slash = menu.rfind('/');
    if (!menu.empty()) return std::string(slash == menu.npos ? menu : menu.substr(slash + 1));
    return "Other";
}

}  // namespace tp
