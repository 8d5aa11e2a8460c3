// What is selected, with everything that can be changed about it.
#include "../widgets.h"
#include "panels.h"

#include <teapath/editor/scene_edits.h>
#include <teapath/scene/enum_tables.h>

#include <fmt/format.h>
#include <imgui.h>

namespace tp {
namespace {

struct ShapeRows {
    bool operator()(SphereShape& s) const {
        bool changed =
            ui::row("Centre", s.center, Double3(0), 0.02, "%.3f", "In the object's own space");
        return ui::row("Radius", s.radius, 1.0, 0.005, -1e6, 1e6, "%.3f",
                       "Negative turns the normal inwards, as for a bubble in glass") ||
               changed;
    }
    template <class Rect>
    bool axis_rect(Rect& r) const {
        bool changed = ui::row("Low", r.low, Double2(-0.5), 0.02, "%.3f", "The lower corner");
        changed |= ui::row("High", r.high, Double2(0.5), 0.02, "%.3f", "The upper corner");
        changed |= ui::row("Offset", r.k, 0.0, 0.02, -1e9, 1e9, "%.3f", "Place on the third axis");
        r.high = glm::max(r.high, r.low);
        return changed;
    }
    bool operator()(XyRectShape& r) const { return axis_rect(r); }
    bool operator()(XzRectShape& r) const { return axis_rect(r); }
    bool operator()(YzRectShape& r) const { return axis_rect(r); }
    bool operator()(RectangleShape& r) const {
        bool changed = ui::row("Corner", r.corner, Double3(0), 0.02, "%.3f",
                               "Where texture coordinates are 0");
        changed |=
            ui::row("Edge u", r.edge_u, Double3(1, 0, 0), 0.02, "%.3f", "From the corner along u");
        return ui::row("Edge v", r.edge_v, Double3(0, 0, -1), 0.02, "%.3f",
                       "From the corner along v") ||
               changed;
    }
    bool operator()(BoxShape& b) const {
        bool changed = ui::row("Low", b.low, Double3(-0.5), 0.02, "%.3f", "The lower corner");
        changed |= ui::row("High", b.high, Double3(0.5), 0.02, "%.3f", "The upper corner");
        b.high = glm::max(b.high, b.low);
        return changed;
    }
    bool operator()(DiskShape& d) const {
        bool changed =
            ui::row("Centre", d.center, Double3(0), 0.02, "%.3f", "In the object's own space");
        const Double3 before = d.normal;
        changed |=
            ui::row("Normal", d.normal, Double3(0, 1, 0), 0.01, "%.3f", "Direction of the front");
        if (!(glm::length(d.normal) > 0)) d.normal = before;
        return ui::row("Radius", d.radius, 1.0, 0.005, 0, 1e6, "%.3f",
                       "In the object's own space") ||
               changed;
    }
    bool operator()(TriangleShape& t) const {
        bool changed = ui::row("A", t.a, Double3(0), 0.02, "%.3f", "First corner");
        changed |= ui::row("B", t.b, Double3(0), 0.02, "%.3f",
                           "Second corner, counter-clockwise from the front");
        return ui::row("C", t.c, Double3(0), 0.02, "%.3f", "Third corner") || changed;
    }
};

bool draw_textured_color(PanelContext& c, const char* name, TexturedColor& color,
                         const char* help) {
    if (!color.texture) return ui::row_color(name, color.color, help);
    const Texture* texture = find(c.document.scene(), color.texture);
    ui::label(name, help);
    ImGui::TextUnformatted(texture && !texture->name.empty() ? texture->name.c_str() : "texture");
    ImGui::SameLine();
    if (!ImGui::SmallButton("Remove")) return false;
    color.texture = {};
    return true;
}

bool material_rows(PanelContext& c, Material& m) {
    bool changed =
        ui::row("Name", m.name, "In the scene file; empty writes the material where it is used");
    const MaterialKind before = m.kind;
    changed |= ui::row("Kind", m.kind, "How the surface scatters");
    if (before != m.kind && m.kind == MaterialKind::Dielectric) m.color.color = {1, 1, 1};
    if (m.kind != MaterialKind::DiffuseLight)
        changed |= draw_textured_color(c, "Colour", m.color, "Albedo, reflectance or tint");
    if (m.kind == MaterialKind::Metal)
        changed |=
            ui::row("Fuzz", m.fuzz, 0.0, 0.005, 0, 1, "%.3f", "Blurs the reflection, 0 to 1");
    if (m.kind == MaterialKind::Dielectric) {
        changed |=
            ui::row("Index", m.ior, 1.5, 0.005, 0.01, 10, "%.3f",
                    "Index of refraction behind the surface: water 1.33, glass 1.5, diamond 2.42");
        changed |= ui::row("Outside index", m.exterior_ior, 1.0, 0.005, 0.01, 10, "%.3f",
                           "Index of refraction before the surface");
        changed |= ui::row("Fresnel", m.fresnel, "Share of light that is reflected");
    }
    if (m.kind != MaterialKind::DiffuseLight)
        changed |= ui::row("Emits", m.emits, "Gives light beside scattering it");
    if (m.emits || m.kind == MaterialKind::DiffuseLight) {
        changed |= draw_textured_color(c, "Emission", m.emission, "Radiance of each channel");
        changed |=
            ui::row("Strength", m.strength, 1.0, 0.05, 0, 1e6, "%.2f", "Multiplies the emission");
        changed |= ui::row("Emits on", m.side, "Which side gives light");
    }
    changed |= ui::row("Opacity", m.opacity, 1.0, 0.005, 0, 1, "%.2f",
                       "Share of light that meets the surface; the rest goes straight on");
    if (m.opacity < 1)
        changed |= ui::row_color("Pass colour", m.pass_through, "Colour of what goes straight on");
    return changed;
}

void draw_material(PanelContext& c, MaterialId id) {
    const Material* found = find(c.document.scene(), id);
    if (!found) return;
    Material material = *found;
    if (!ui::begin_rows("material")) return;
    const bool changed = material_rows(c, material);
    ui::end_rows();
    if (changed)
        c.document.edit(fmt::format("Change {}", display_name(*found)),
                        fmt::format("material {}", id.value), [&](Scene& s) {
                            if (Material* m = find_material(s, id)) *m = material;
                        });
}

bool material_slot(PanelContext& c, Object& object) {
    const Scene& scene = c.document.scene();
    const Material* current = find(scene, object.material);
    ui::label("Material", "What the object is made of; several objects may share one");
    ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 3.4f);
    bool changed = false;
    if (ImGui::BeginCombo("##material", current ? display_name(*current).c_str() : "default")) {
        for (const Material& m : scene.materials) {
            ImGui::PushID(static_cast<int>(m.id.value));
            if (ImGui::Selectable(display_name(m).c_str(), m.id == object.material)) {
                object.material = m.id;
                changed = true;
            }
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    ImGui::SameLine();
    if (ImGui::Button("New"))
        c.document.edit("New material", "", [id = object.id, like = object.material](Scene& s) {
            const MaterialId made = add_material(s, MaterialKind::Lambertian, like);
            if (Object* o = find_object(s, id)) o->material = made;
        });
    ui::tooltip("A copy of this material for this object alone");
    return changed;
}

void draw_object(PanelContext& c, ObjectId id) {
    const Object* found = find(c.document.scene(), id);
    if (!found) return;
    Object object = *found;
    const Transform standard;
    bool changed = false;
    if (ui::begin_rows("object")) {
        changed |= ui::row("Name", object.name, "Shown in the tree");
        changed |= ui::row("Position", object.transform.translation, standard.translation, 0.02,
                           "%.3f", "Scene units");
        changed |= ui::row("Rotation", object.transform.rotation, standard.rotation, 0.5,
                           "%.1f\xc2\xb0", "Degrees about x, then y, then z");
        const Double3 before = object.transform.scale;
        changed |= ui::row("Scale", object.transform.scale, standard.scale, 0.01, "%.3f",
                           "Along the object's own axes");
        for (int i = 0; i < 3; ++i)
            if (object.transform.scale[i] == 0) object.transform.scale[i] = before[i];
        ui::end_rows();
    }
    ImGui::SeparatorText(shape_kinds()[object.shape.index()].label);
    if (ui::begin_rows("shape")) {
        changed |= std::visit(ShapeRows{}, object.shape);
        changed |= ui::row("Inside out", object.inside_out, "Turns the front round");
        ui::end_rows();
    }
    ImGui::SeparatorText("Material");
    if (ui::begin_rows("slot")) {
        changed |= material_slot(c, object);
        ui::end_rows();
    }
    if (changed)
        c.document.edit(fmt::format("Change {}", display_name(*found)),
                        fmt::format("object {}", id.value), [&](Scene& s) {
                            if (Object* o = find_object(s, id)) *o = object;
                        });
    draw_material(c, object.material);
}

}  // namespace

void draw_inspector(PanelContext& c) {
    if (begin_panel(c, "Inspector")) {
        if (!c.document.selection.empty()) {
            if (c.document.selection.size() > 1)
                ImGui::TextDisabled("%d objects; the last one is shown",
                                    static_cast<int>(c.document.selection.size()));
            draw_object(c, c.document.selection.back());
        } else if (find(c.document.scene(), c.ui.tree.chosen_material)) {
            draw_material(c, c.ui.tree.chosen_material);
        } else {
            ImGui::TextWrapped(
                "Nothing is selected. Click an object in the picture or in the tree; the Add menu "
                "makes a new one.");
        }
        if (!ImGui::IsAnyItemActive() && ImGui::IsMouseReleased(0)) c.document.end_merge();
    }
    ImGui::End();
}

}  // namespace tp
