// Inspector of objects: transform, shape and the material slot.
#include "../preview/previews.h"
#include "inspector.h"

#include <teapath/editor/material_presets.h>
#include <teapath/editor/model_edits.h>
#include <teapath/editor/scene_tree.h>
#include <teapath/scene/enum_tables.h>

#include <icons_font_awesome_6.h>

#include <algorithm>
#include <set>

namespace tp {
namespace {

// The selected objects in the order of the scene with the active one last, and where they are.
struct Selected {
    std::vector<const Object*> objects;
    std::vector<size_t> positions;
    std::vector<ObjectId> ids;
};

Selected selected_objects(const Scene& scene, const std::vector<SceneItem>& items) {
    std::set<uint32_t> wanted;
    for (const SceneItem item : items)
        wanted.insert(item.id);
    Selected selected;
    size_t active = 0;
    for (size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& o = scene.objects[i];
        if (!wanted.count(o.id.value)) continue;
        if (o.id.value == items.back().id) active = selected.objects.size();
        selected.objects.push_back(&o);
        selected.positions.push_back(i);
        selected.ids.push_back(o.id);
    }
    if (!selected.objects.empty()) {
        std::swap(selected.objects[active], selected.objects.back());
        std::swap(selected.positions[active], selected.positions.back());
        std::swap(selected.ids[active], selected.ids.back());
    }
    return selected;
}

void transform_rows(PropertyRows<Object>& rows) {
    rows.number(
        {.name = "Position",
         .help = "Where the object's origin is, in scene units",
         .speed = 0.01,
         .is_axis = true},
        [](auto& o) -> auto& { return o.transform.translation; });
    rows.number(
        {.name = "Rotation",
         .help = "Degrees about the world's x, then y, then z axis",
         .speed = 0.5,
         .decimals = 1,
         .unit = "\xc2\xb0",
         .is_axis = true},
        [](auto& o) -> auto& { return o.transform.rotation; });
    rows.number(
        {.name = "Scale",
         .help = "Along the object's own axes; negative mirrors, 0 is refused",
         .speed = 0.01,
         .is_axis = true},
        [](auto& o) -> auto& { return o.transform.scale; });
}

void flag_rows(PropertyRows<Object>& rows) {
    rows.toggle(
        "Visible", "Hidden objects are not rendered", [](auto& o) -> auto& { return o.visible; });
    rows.toggle(
        "To the camera", "Seen by the camera itself",
        [](auto& o) -> auto& { return o.camera_visible; });
    rows.toggle(
        "Casts shadows", "Stands in the way of what lights shine at",
        [](auto& o) -> auto& { return o.casts_shadows; });
    rows.toggle(
        "In reflections", "Met by scattered light: in mirrors, behind glass, in indirect light",
        [](auto& o) -> auto& { return o.reflection_visible; });
    rows.toggle(
        "Inside out", "Turns the front, and with it the normal, round",
        [](auto& o) -> auto& { return o.inside_out; });
}

void set_material(PanelContext& c, const std::vector<ObjectId>& ids, MaterialId material) {
    c.document.edit("Set material", "", [&](Scene& s) { assign_material(s, ids, material); });
}

// Makes a material and gives it to the objects, as one edit.
void new_material_for(PanelContext& c, const std::vector<ObjectId>& ids, const Material& like) {
    c.document.edit("New material", "",
                    [&](Scene& s) { assign_material(s, ids, add_material(s, like)); });
}

void new_material_menu(PanelContext& c, const std::vector<ObjectId>& ids, MaterialId current) {
    if (!ImGui::BeginPopup("new material")) return;
    const Material* original = find(c.document.scene(), current);
    if (ImGui::MenuItem("Copy of this one", nullptr, false, original != nullptr))
        new_material_for(c, ids, Material(*original));
    ImGui::Separator();
    for (const auto& kind : EnumTable<MaterialKind>::rows)
        if (ImGui::MenuItem(std::string(kind.label).c_str()))
            new_material_for(c, ids, new_material(kind.value));
    ImGui::Separator();
    const char* group = "";
    bool open = false;
    for (const MaterialPreset& preset : material_presets()) {
        if (std::string_view(group) != preset.group) {
            if (open) ImGui::EndMenu();
            open = ImGui::BeginMenu(group = preset.group);
        }
        if (open && ImGui::MenuItem(preset.material.name.c_str()))
            new_material_for(c, ids, preset.material);
    }
    if (open) ImGui::EndMenu();
    ImGui::EndPopup();
}

void material_list(PanelContext& c, const std::vector<ObjectId>& ids, MaterialId current,
                   bool mixed) {
    const ScenePtr scene = c.document.snapshot();
    const float size = ImGui::GetTextLineHeight();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(scene->materials.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const Material& m = scene->materials[static_cast<size_t>(i)];
            ImGui::PushID(static_cast<int>(m.id.value));
            const uint64_t picture = c.ui.previews ? c.ui.previews->material(*scene, m) : 0;
            if (picture)
                ImGui::Image(static_cast<ImTextureID>(picture), {size, size});
            else
                ImGui::Dummy({size, size});
            ImGui::SameLine();
            if (ImGui::Selectable(display_name(m).c_str(), !mixed && m.id == current))
                set_material(c, ids, m.id);
            ImGui::PopID();
        }
}

void material_slot(PropertyRows<Object>& rows, const std::vector<ObjectId>& ids) {
    PanelContext& c = rows.context();
    const auto material_of = [](auto& o) -> auto& {
        return o.material;
    };
    const MaterialId current = rows.active().material;
    const bool mixed = !rows.is_same(material_of);
    const Material* material = find(c.document.scene(), current);
    ui::begin_row("Material", "What the object is made of; several objects may share one");
    const float button = ImGui::GetFrameHeight() + ui::px(2);
    const float width = std::max(1.0f, ImGui::GetContentRegionAvail().x - button);
    ImGui::SetNextItemWidth(width);
    const std::string name = mixed ? "mixed" : material ? display_name(*material) : "default";
    if (ImGui::BeginCombo("##material",
                          ui::fitted(name, width - ImGui::GetFrameHeight() - ui::px(12)).c_str())) {
        material_list(c, ids, current, mixed);
        ImGui::EndCombo();
    }
    if (ImGui::BeginDragDropTarget()) {
        if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload("material"))
            set_material(c, ids, *static_cast<const MaterialId*>(payload->Data));
        ImGui::EndDragDropTarget();
    }
    ImGui::SameLine(0, ui::px(2));
    if (ui::icon_button(ICON_FA_PLUS "##new", "New: a copy, another kind, or a preset"))
        ImGui::OpenPopup("new material");
    new_material_menu(c, ids, current);
}

const char* shape_icon(const Object& o) {
    switch (o.shape.index()) {
        case 0: return ICON_FA_CIRCLE;
        case 5: return ICON_FA_CUBE;
        case 6: return ICON_FA_COMPACT_DISC;
        case 7: return ICON_FA_PLAY;
        default: return ICON_FA_SQUARE;
    }
}

}  // namespace

void object_inspector(PanelContext& c, const std::vector<SceneItem>& items) {
    const ScenePtr scene = c.document.snapshot();
    const Selected selected = selected_objects(*scene, items);
    if (selected.objects.empty()) return;
    const Object& active = *selected.objects.back();
    Object standard;
    standard.shape = shape_kinds()[active.shape.index()].shape;
    const bool one = selected.objects.size() == 1;
    PropertyRows<Object> rows(
        c, one ? display_name(active) : fmt::format("{} objects", selected.objects.size()),
        fmt::format("object {}", active.id.value), selected.objects,
        [positions = selected.positions, ids = selected.ids](Scene& s, size_t i) {
            const size_t at = positions[i];
            return at < s.objects.size() && s.objects[at].id == ids[i] ? &s.objects.edit()[at]
                                                                       : nullptr;
        },
        standard);
    const bool same_shape = rows.is_same([](auto& o) { return o.shape.index(); });
    std::string kind = same_shape ? shape_kinds()[active.shape.index()].label : "Different shapes";
    if (const Model* model = find(*scene, active.part.model); model && one)
        kind += fmt::format(" of {}", model->name);
    inspector_header(c, items, shape_icon(active), kind);

    std::vector<std::string>& folded = c.ui.preferences.folded;
    if (ui::section("Transform", folded) && ui::begin_rows("transform")) {
        transform_rows(rows);
        ui::end_rows();
    }
    if (ui::section("Shape", folded) && ui::begin_rows("shape")) {
        if (same_shape) shape_rows(rows);
        flag_rows(rows);
        ui::end_rows();
    }
    if (!ui::section("Material", folded)) return;
    if (ui::begin_rows("slot")) {
        material_slot(rows, selected.ids);
        ui::end_rows();
    }
    std::set<uint32_t> seen;
    std::vector<MaterialId> materials;
    for (const Object* o : selected.objects)
        if (o != &active && o->material != active.material && seen.insert(o->material.value).second)
            materials.push_back(o->material);
    materials.push_back(active.material);
    material_rows(c, materials);
}

}  // namespace tp
