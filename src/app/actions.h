// Everything that a user can do by a menu, a key or a button, once: the menus, the shortcuts, the
// table of keys, the settings of keys and the tests all read this table.
#pragma once

#include "context.h"

#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// Where the keys of an action act. No key acts while text is typed, but those with Ctrl.
enum class ActionScope : uint8_t {
    Anywhere,
    Viewport,  // where the picture has the focus
    Held       // in the viewport, for as long as the key is down: flying; `run` is null
};

struct Action {
    const char* id;    // "file.open": its name in the key settings and in tests
    const char* menu;  // "File", or "View/Bookmarks" in a submenu; "" = in no menu
    const char* label;
    const char* help;      // one sentence for the tooltip and the table of keys
    int keys[2] = {0, 0};  // ImGuiKeyChord as shipped; 0 = none
    ActionScope scope = ActionScope::Anywhere;
    void (*run)(PanelContext&) = nullptr;
    bool (*is_enabled)(const PanelContext&) = nullptr;      // null: always
    bool (*is_checked)(const PanelContext&) = nullptr;      // null: no tick
    std::string (*title)(const PanelContext&) = nullptr;    // null: the label
    bool starts_group = false;                              // a line above it in the menu
    std::string (*why_not)(const PanelContext&) = nullptr;  // while greyed: the reason, for its tip
    void (*more)(PanelContext&) = nullptr;  // draws items that are no actions; `run` is null then
};

/// All actions, in the order of the menus.
const std::vector<Action>& actions();

/// The action of that id; throws std::out_of_range for an unknown one.
const Action& action(std::string_view id);

bool is_enabled(const Action& action, const PanelContext& c);

/// Runs the action if it is enabled.
void run_action(std::string_view id, PanelContext& c);

/// Runs what the keys pressed in this frame ask for. Called once a frame, after the panels.
void run_shortcuts(PanelContext& c);

/// The items of one menu and, for actions of "View/Bookmarks", of its submenus.
void draw_menu_items(PanelContext& c, std::string_view menu);

/// The heading that the action has in lists of keys: its innermost menu, or "Fly".
std::string group_of(const Action& action);

// The parts of the table, one file each in actions/.
std::vector<Action> file_actions();
std::vector<Action> edit_actions();
std::vector<Action> view_actions();
std::vector<Action> camera_actions();
std::vector<Action> viewport_actions();
std::vector<Action> render_actions();
std::vector<Action> help_actions();

}  // namespace tp
