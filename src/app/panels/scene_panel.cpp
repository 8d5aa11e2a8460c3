// The tree of objects and materials.
#include "../widgets.h"
#include "panels.h"

#include <teapath/editor/scene_edits.h>

#include <fmt/format.h>
#include <icons_font_awesome_6.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace tp {
namespace {

bool matches(const std::string& name, const std::string& search) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) ==
               std::tolower(static_cast<unsigned char>(b));
    };
    return search.empty() ||
           std::search(name.begin(), name.end(), search.begin(), search.end(), same) != name.end();
}

const char* icon_of(const Object& o) {
    switch (o.shape.index()) {
        case 0: return ICON_FA_CIRCLE;
        case 5: return ICON_FA_CUBE;
        case 6: return ICON_FA_COMPACT_DISC;
        case 7: return ICON_FA_PLAY;
        default: return ICON_FA_SQUARE;
    }
}

void draw_object_row(PanelContext& c, const Object& object) {
    ImGui::PushID(static_cast<int>(object.id.value));
    if (ImGui::SmallButton(object.visible ? ICON_FA_EYE : ICON_FA_EYE_SLASH))
        c.document.edit(object.visible ? "Hide" : "Show", "", [id = object.id](Scene& s) {
            if (Object* o = find_object(s, id)) o->visible = !o->visible;
        });
    ui::tooltip("Show or hide");
    ImGui::SameLine();
    const std::string text = fmt::format("{}  {}", icon_of(object), display_name(object));
    if (!object.visible)
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    if (ImGui::Selectable(text.c_str(), c.document.is_selected(object.id)))
        c.document.select(object.id, ImGui::GetIO().KeyCtrl || ImGui::GetIO().KeyShift);
    if (!object.visible) ImGui::PopStyleColor();
    if (ImGui::BeginPopupContextItem()) {
        if (!c.document.is_selected(object.id)) c.document.select(object.id);
        const std::vector<ObjectId> ids = c.document.selection;
        if (ImGui::MenuItem("Duplicate"))
            c.document.edit("Duplicate", "", [&](Scene& s) { duplicate_objects(s, ids); });
        if (ImGui::MenuItem("Delete"))
            c.document.edit("Delete", "", [&](Scene& s) { delete_objects(s, ids); });
        ImGui::EndPopup();
    }
    ImGui::PopID();
}

// Only the rows in sight are drawn, so that a hundred thousand objects cost nothing.
void draw_objects(PanelContext& c) {
    const std::vector<Object>& objects = c.document.scene().objects;
    std::vector<size_t> shown;
    for (size_t i = 0; i < objects.size(); ++i)
        if (matches(display_name(objects[i]), c.ui.tree.search)) shown.push_back(i);
    const ScenePtr scene = c.document.snapshot();  // rows may edit the scene while it is walked
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(shown.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            draw_object_row(c, scene->objects[shown[static_cast<size_t>(i)]]);
}

void draw_materials(PanelContext& c) {
    const ScenePtr scene = c.document.snapshot();
    for (const Material& m : scene->materials) {
        const std::string name = display_name(m);
        if (!matches(name, c.ui.tree.search)) continue;
        ImGui::PushID(static_cast<int>(m.id.value));
        const Double3& color =
            m.kind == MaterialKind::DiffuseLight ? m.emission.color : m.color.color;
        const ImVec4 swatch(static_cast<float>(std::sqrt(std::clamp(color.x, 0.0, 1.0))),
                            static_cast<float>(std::sqrt(std::clamp(color.y, 0.0, 1.0))),
                            static_cast<float>(std::sqrt(std::clamp(color.z, 0.0, 1.0))), 1);
        ImGui::ColorButton("##swatch", swatch, ImGuiColorEditFlags_NoTooltip, ImVec2(14, 14));
        ImGui::SameLine();
        if (ImGui::Selectable(name.c_str(),
                              c.document.selection.empty() && c.ui.tree.chosen_material == m.id)) {
            c.document.selection.clear();
            c.ui.tree.chosen_material = m.id;
        }
        ImGui::PopID();
    }
}

}  // namespace

void draw_scene_tree(PanelContext& c) {
    if (begin_panel(c, "Scene")) {
        ImGui::SetNextItemWidth(-1);
        ImGui::InputTextWithHint("##search", ICON_FA_MAGNIFYING_GLASS "  Search",
                                 &c.ui.tree.search);
        const Scene& scene = c.document.scene();
        if (ui::section(fmt::format("Objects ({})###objects", scene.objects.size()).c_str()))
            draw_objects(c);
        for (const Generator& g : scene.generators)
            ImGui::BulletText("%s: %d x %d spheres",
                              g.name.empty() ? "sphere grid" : g.name.c_str(), g.grid.columns,
                              g.grid.rows);
        if (!c.document.scene().generators.empty() &&
            ui::button("Make the generated objects editable"))
            c.document.edit("Make editable", "", [](Scene& s) { realize_generators(s); });
        if (ui::section(
                fmt::format("Materials ({})###materials", c.document.scene().materials.size())
                    .c_str()))
            draw_materials(c);
    }
    ImGui::End();
}

}  // namespace tp
