// How the window looks: panels, layouts, theme, full screen.
#include "../actions.h"
#include "../layouts.h"
#include "../panels/panels.h"

#include <imgui.h>

#include <utility>

namespace tp {
namespace {

// One action for each panel of the table; a plain function knows its panel by its number.
template <size_t N>
void toggle_panel(PanelContext& c) {
    const char* title = panels()[N].title;
    c.ui.preferences.set_panel_open(title, !c.ui.preferences.is_panel_open(title));
}

template <size_t N>
bool is_panel_open(const PanelContext& c) {
    return c.ui.preferences.is_panel_open(panels()[N].title);
}

constexpr const char* kPanelIds[] = {"panel.viewport",  "panel.options", "panel.scene",
                                     "panel.inspector", "panel.console", "panel.metrics",
                                     "panel.history"};

template <size_t... N>
std::vector<Action> panel_actions(std::index_sequence<N...>) {
    return {Action{.id = kPanelIds[N],
                   .menu = "View",
                   .label = panels()[N].title,
                   .help = "Shows or hides this panel",
                   .run = toggle_panel<N>,
                   .is_checked = is_panel_open<N>}...};
}

Action layout_action(const char* id, const char* label, const char* help,
                     void (*run)(PanelContext&)) {
    return {.id = id, .menu = "View/Layouts", .label = label, .help = help, .run = run};
}

}  // namespace

std::vector<Action> view_actions() {
    std::vector<Action> table = panel_actions(std::make_index_sequence<std::size(kPanelIds)>());
    const std::vector<Action> others = {
        layout_action("layout.edit", "Edit", "Picture in the middle, panels around it",
                      [](PanelContext& c) { choose_layout(c, "Edit"); }),
        layout_action("layout.render", "Render", "The picture alone, and the status bar",
                      [](PanelContext& c) { choose_layout(c, "Render"); }),
        layout_action("layout.inspect", "Inspect", "Metrics and inspector large",
                      [](PanelContext& c) { choose_layout(c, "Inspect"); }),
        {.id = "layout.saved",
         .menu = "View/Layouts",
         .label = "Saved layouts",
         .help = "",
         .more = draw_saved_layouts},
        {.id = "view.reset_layout",
         .menu = "View",
         .label = "Reset layout",
         .help = "Puts every panel where it was at first",
         .run = [](PanelContext& c) { c.ui.reset_layout = true; },
         .starts_group = true},
        {.id = "view.full_screen",
         .menu = "View",
         .label = "Full screen",
         .help = "On the monitor that the window is on",
         .keys = {ImGuiKey_F11},
         .run = [](PanelContext& c) { c.window.toggle_full_screen(); },
         .is_checked = [](const PanelContext& c) { return c.window.is_full_screen(); }},
        {.id = "view.light_theme",
         .menu = "View",
         .label = "Light theme",
         .help = "Light panels instead of dark ones",
         .run = [](PanelContext& c) { c.ui.preferences.dark_theme = !c.ui.preferences.dark_theme; },
         .is_checked = [](const PanelContext& c) { return !c.ui.preferences.dark_theme; }},
    };
    table.insert(table.end(), others.begin(), others.end());
    return table;
}

}  // namespace tp
