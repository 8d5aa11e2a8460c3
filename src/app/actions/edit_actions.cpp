// Undo, redo, and what is done to the selection.
#include "../actions.h"
#include "../panels/scene_tree_parts.h"

#include <teapath/editor/scene_edits.h>

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace tp {
namespace {

bool has_selection(const PanelContext& c) {
    return !c.document.selected_items().empty();
}

bool can_delete(const PanelContext& c) {
    const std::vector<SceneItem> items = c.document.selected_items();
    return std::any_of(items.begin(), items.end(), [&](SceneItem item) {
        return why_not_deleted(c.document.scene(), item).empty();
    });
}

std::string undo_title(const PanelContext& c) {
    if (!c.document.can_undo()) return "Undo";
    return fmt::format("Undo {}", c.document.history()[c.document.history_position()].label);
}

std::string redo_title(const PanelContext& c) {
    if (!c.document.can_redo()) return "Redo";
    return fmt::format("Redo {}", c.document.history()[c.document.history_position() + 1].label);
}

void duplicate(PanelContext& c) {
    std::vector<SceneItem> made;
    c.document.edit("Duplicate", "",
                    [&](Scene& s) { made = duplicate_items(s, c.document.selected_items()); });
    if (!made.empty()) c.document.select_items(made);
}

void delete_selection(PanelContext& c) {
    c.document.edit("Delete", "",
                    [items = c.document.selected_items()](Scene& s) { delete_items(s, items); });
}

void rename_selection(PanelContext& c) {
    start_rename(c, c.document.selected_items().back());
}

void select_all(PanelContext& c) {
    std::vector<SceneItem> all;
    for (const Object& o : c.document.scene().objects)
        all.push_back(item_of(o.id));
    c.document.select_items(all);
}

void clear_scene(PanelContext& c) {
    c.document.edit("Clear scene", "", [](Scene& s) {
        s.objects = {};
        s.generators = {};
    });
}

}  // namespace

std::vector<Action> edit_actions() {
    return {
        {.id = "edit.undo",
         .menu = "Edit",
         .label = "Undo",
         .help = "Takes the last change back",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_Z},
         .run = [](PanelContext& c) { c.document.undo(); },
         .is_enabled = [](const PanelContext& c) { return c.document.can_undo(); },
         .title = undo_title},
        {.id = "edit.redo",
         .menu = "Edit",
         .label = "Redo",
         .help = "Does again what was taken back",
         .keys = {ImGuiMod_Ctrl | ImGuiMod_Shift | ImGuiKey_Z, ImGuiMod_Ctrl | ImGuiKey_Y},
         .run = [](PanelContext& c) { c.document.redo(); },
         .is_enabled = [](const PanelContext& c) { return c.document.can_redo(); },
         .title = redo_title},
        {.id = "edit.duplicate",
         .menu = "Edit",
         .label = "Duplicate",
         .help = "Copies what is selected; objects stand a little to the side",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_D},
         .run = duplicate,
         .is_enabled = has_selection,
         .starts_group = true},
        {.id = "edit.delete",
         .menu = "Edit",
         .label = "Delete",
         .help = "Removes what is selected",
         .keys = {ImGuiKey_Delete},
         .run = delete_selection,
         .is_enabled = can_delete},
        {.id = "edit.rename",
         .menu = "Edit",
         .label = "Rename",
         .help = "Types another name in the tree",
         .keys = {ImGuiKey_F2},
         .run = rename_selection,
         .is_enabled = has_selection},
        {.id = "edit.select_all",
         .menu = "Edit",
         .label = "Select all",
         .help = "Selects every object",
         .keys = {ImGuiMod_Ctrl | ImGuiKey_A},
         .run = select_all},
        {.id = "edit.clear_scene",
         .menu = "Edit",
         .label = "Clear scene",
         .help = "Removes every object; undo brings them back",
         .run = clear_scene,
         .starts_group = true},
    };
}

}  // namespace tp
