// What a row's menu in the scene tree offers, and how rows are selected.
#include "../actions.h"
#include "../widgets.h"
#include "scene_tree_parts.h"

#include <teapath/editor/model_edits.h>
#include <teapath/editor/scene_edits.h>

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace tp {
namespace {

std::vector<ObjectId> object_ids(const std::vector<SceneItem>& items) {
    std::vector<ObjectId> ids;
    for (const SceneItem item : items)
        if (item.kind == ItemKind::Object) ids.push_back({item.id});
    return ids;
}

void object_items(PanelContext& c, const std::vector<SceneItem>& items) {
    const std::vector<ObjectId> ids = object_ids(items);
    if (ids.empty()) return;
    const Object* first = find(c.document.scene(), ids.front());
    const bool is_visible = first && first->visible;
    if (ImGui::MenuItem(is_visible ? "Hide" : "Show"))
        c.document.edit(is_visible ? "Hide" : "Show", "",
                        [&](Scene& s) { set_visible(s, ids, !is_visible); });
    if (ImGui::MenuItem("Frame in view",
                        chord_name(c.ui.keys.chords("camera.frame_selection")[0]).c_str())) {
        c.document.select_items(items);
        run_action("camera.frame_selection", c);
    }
    if (first &&
        ImGui::MenuItem("Show its material", nullptr, false, static_cast<bool>(first->material)))
        c.document.select(item_of(first->material));
    ImGui::Separator();
}

void material_items(PanelContext& c, SceneItem item) {
    const std::vector<ObjectId> selected = c.document.selection;
    const MaterialId id{item.id};
    if (ImGui::MenuItem("Give to the selected objects", nullptr, false, !selected.empty()))
        c.document.edit("Set material", "", [&](Scene& s) { assign_material(s, selected, id); });
    if (ImGui::MenuItem("Select the objects that have it")) {
        std::vector<SceneItem> users;
        for (const Object& o : c.document.scene().objects)
            if (o.material == id) users.push_back(item_of(o.id));
        if (!users.empty()) c.document.select_items(users);
    }
    ImGui::Separator();
}

void model_items(PanelContext& c, SceneItem item) {
    const std::vector<ObjectId> ids = objects_of(c.document.scene(), ModelId{item.id});
    if (ImGui::MenuItem("Select its objects", nullptr, false, !ids.empty())) {
        std::vector<SceneItem> objects;
        for (const ObjectId id : ids)
            objects.push_back(item_of(id));
        c.document.select_items(objects);
    }
    if (ImGui::MenuItem("Hide", nullptr, false, !ids.empty()))
        c.document.edit("Hide", "", [&](Scene& s) { set_visible(s, ids, false); });
    if (ImGui::MenuItem("Show", nullptr, false, !ids.empty()))
        c.document.edit("Show", "", [&](Scene& s) { set_visible(s, ids, true); });
    ImGui::Separator();
}

void camera_items(PanelContext& c, SceneItem item) {
    const Camera view = active_camera(c.document.scene());
    const bool is_default = view.id == CameraId{item.id};
    if (ImGui::MenuItem("Set as default", nullptr, is_default, !is_default))
        c.document.edit("Choose camera", "", [&](Scene& s) { s.active_camera = {item.id}; });
    ui::tooltip("The window looks through it, and so does what renders the file");
    if (ImGui::MenuItem("Give it this view", nullptr, false, !is_default))
        c.document.edit("Place camera", "", [&](Scene& s) {
            Camera& camera = *find_camera(s, {item.id});
            camera.look_from = view.look_from;
            camera.look_at = view.look_at;
            camera.up = view.up;
        });
    ui::tooltip("It stands where you look from now, and looks the same way");
    ImGui::Separator();
}

}  // namespace

void scene_row_menu(PanelContext& c, const std::vector<SceneItem>& items) {
    if (items.empty()) return;
    const SceneItem item = items.back();
    if (item.kind == ItemKind::Object) object_items(c, items);
    if (item.kind == ItemKind::Material && items.size() == 1) material_items(c, item);
    if (item.kind == ItemKind::Model && items.size() == 1) model_items(c, item);
    if (item.kind == ItemKind::Camera && items.size() == 1) camera_items(c, item);
    if (item.kind == ItemKind::Generator) {
        if (ImGui::MenuItem("Make editable"))
            c.document.edit("Make editable", "", [](Scene& s) { realize_generators(s); });
        ImGui::Separator();
    }
    const bool is_background = item.kind == ItemKind::Background;
    if (ImGui::MenuItem("Rename", chord_name(c.ui.keys.chords("edit.rename")[0]).c_str(), false,
                        items.size() == 1 && !is_background))
        start_rename(c, item);
    if (ImGui::MenuItem("Duplicate", nullptr, false, !is_background)) {
        std::vector<SceneItem> made;
        c.document.edit("Duplicate", "", [&](Scene& s) { made = duplicate_items(s, items); });
        c.document.select_items(made);
    }
    const std::string reason = why_not_deleted(c.document.scene(), item);
    if (ImGui::MenuItem("Delete", nullptr, false, reason.empty()))
        c.document.edit("Delete", "", [&](Scene& s) { delete_items(s, items); });
    ui::tooltip(reason.c_str());
}

void select_by_click(PanelContext& c, TreeSection section, size_t index, bool add, bool range) {
    SceneTreeState& tree = c.ui.tree;
    const std::vector<SceneItem>& rows = tree.rows.rows(section);
    const SceneItem item = rows[index];
    const auto anchor = std::find(rows.begin(), rows.end(), tree.anchor);
    if (range && anchor != rows.end()) {
        const auto at = static_cast<size_t>(anchor - rows.begin());
        std::vector<SceneItem> chosen;
        if (add) chosen = c.document.selected_items();
        for (size_t i = std::min(at, index); i <= std::max(at, index); ++i)
            if (i != index && std::find(chosen.begin(), chosen.end(), rows[i]) == chosen.end())
                chosen.push_back(rows[i]);
        std::erase(chosen, item);
        chosen.push_back(item);  // the row that was clicked is the active one
        c.document.select_items(chosen);
    } else {
        c.document.select(item, add);
        tree.anchor = item;
    }
    tree.shown = item;  // it is in sight
}

}  // namespace tp
