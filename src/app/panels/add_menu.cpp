#include "add_menu.h"

#include "../dialogs/dialogs.h"
#include "../fly_camera.h"
#include "../place_in_view.h"

#include <teapath/editor/material_presets.h>
#include <teapath/scene/enum_tables.h>
#include <teapath/scene/procedural_mesh.h>

#include <fmt/format.h>
#include <icons_font_awesome_6.h>
#include <imgui.h>

#include <string>

namespace tp {
namespace {

// Half the height of a new object of size 1 above its origin's lowest point.
double height_below(const Shape& shape) {
    Object object;
    object.shape = shape;
    if (std::holds_alternative<XyRectShape>(shape) || std::holds_alternative<YzRectShape>(shape) ||
        std::holds_alternative<SphereShape>(shape) || std::holds_alternative<BoxShape>(shape))
        return 0.5;
    if (std::holds_alternative<TriangleShape>(shape)) return 0.4;
    return 0.002;  // flat ones lie a little above what they lie on
}

// A size that is well seen at that distance.
double size_at(const Scene& scene, double distance) {
    const double wanted = seen_height(active_camera(scene), distance) / 4;
    // Round numbers read better: 1, 2 or 5 times a power of ten.
    const double power = std::pow(10, std::floor(std::log10(wanted)));
    return power * (wanted / power < 2 ? 1 : wanted / power < 5 ? 2 : 5);
}

void add_shape(PanelContext& c, const ShapeKind& kind, const Material* material) {
    const Place place = place_in_view(c.document.scene());
    const double size = size_at(c.document.scene(), place.distance);
    Double3 point = place.point;
    if (place.is_surface) point.y += height_below(kind.shape) * size;
    ObjectId made;
    c.document.edit(fmt::format("Add {}", kind.label), "", [&](Scene& s) {
        made = add_object(s, kind, point, size);
        Object* object = find_object(s, made);
        if (!material || !object) return;
        if (Material* m = find_material(s, object->material)) {
            const MaterialId id = m->id;
            *m = *material;
            m->id = id;
            m->name.clear();
            rename_item(s, item_of(id), material->name);
        }
    });
    c.document.select(made);
}

const char* icon_of(const Shape& shape) {
    switch (shape.index()) {
        case 0: return ICON_FA_CIRCLE;
        case 5: return ICON_FA_CUBE;
        case 6: return ICON_FA_COMPACT_DISC;
        case 7: return ICON_FA_PLAY;
        default: return ICON_FA_SQUARE;
    }
}

// The meshes that the program makes itself, with their parameters as the inspector shows them.
void add_mesh_items(PanelContext& c) {
    for (const ProceduralKind& kind : procedural_kinds()) {
        if (!ImGui::MenuItem(kind.label)) continue;
        const std::string_view parameters = kind.parameters;
        make_mesh(c,
                  fmt::format("procedural://{}{}{}", kind.name, parameters.empty() ? "" : "?",
                              parameters),
                  kind.label);
    }
}

void add_new_material(PanelContext& c, const Material& like) {
    MaterialId made;
    c.document.edit("Add material", "", [&](Scene& s) { made = tp::add_material(s, like); });
    c.document.select(item_of(made));
}

void add_new_texture(PanelContext& c, TextureKind kind) {
    TextureId made;
    c.document.edit("Add texture", "", [&](Scene& s) { made = tp::add_texture(s, kind); });
    c.document.select(item_of(made));
}

}  // namespace

void add_object_items(PanelContext& c) {
    for (const ShapeKind& kind : shape_kinds()) {
        if (std::holds_alternative<MeshShape>(kind.shape)) continue;  // a file brings it
        if (ImGui::MenuItem(
                fmt::format("{}  {}###{}", icon_of(kind.shape), kind.label, kind.label).c_str()))
            add_shape(c, kind, nullptr);
    }
    ImGui::Separator();
    if (ImGui::MenuItem(ICON_FA_SHAPES "  Model from a file\xe2\x80\xa6###Model from a file"))
        ask_for_model(c);
    if (ImGui::BeginMenu(ICON_FA_CUBES "  Made mesh###Made mesh")) {
        add_mesh_items(c);
        ImGui::EndMenu();
    }
    if (ImGui::MenuItem(ICON_FA_TABLE_CELLS "  Sphere grid###Sphere grid")) {
        GeneratorId made;
        const Place place = place_in_view(c.document.scene());
        c.document.edit("Add sphere grid", "",
                        [&](Scene& s) { made = add_sphere_grid(s, place.point); });
        c.document.select(item_of(made));
    }
}

void add_light_items(PanelContext& c) {
    Material light = new_material(MaterialKind::DiffuseLight);
    light.name = "light";
    for (const size_t shape : {size_t{0}, size_t{2}, size_t{6}}) {
        const ShapeKind& kind = shape_kinds()[shape];
        if (ImGui::MenuItem(
                fmt::format(ICON_FA_LIGHTBULB "  {} light###{} light", kind.label, kind.label)
                    .c_str()))
            add_shape(c, kind, &light);
    }
}

void add_camera(PanelContext& c) {
    CameraId made;
    c.document.edit("Add camera", "",
                    [&](Scene& s) { made = tp::add_camera(s, active_camera(s)); });
    c.document.select(item_of(made));
}

void add_material_items(PanelContext& c) {
    for (const auto& kind : EnumTable<MaterialKind>::rows)
        if (ImGui::MenuItem(std::string(kind.label).c_str()))
            add_new_material(c, new_material(kind.value));
    ImGui::Separator();
    const char* group = "";
    bool open = false;
    for (const MaterialPreset& preset : material_presets()) {
        if (std::string_view(group) != preset.group) {
            if (open) ImGui::EndMenu();
            open = ImGui::BeginMenu(group = preset.group);
        }
        if (open && ImGui::MenuItem(preset.material.name.c_str()))
            add_new_material(c, preset.material);
    }
    if (open) ImGui::EndMenu();
}

void add_texture_items(PanelContext& c) {
    for (const auto& kind : EnumTable<TextureKind>::rows)
        if (ImGui::MenuItem(std::string(kind.label).c_str())) add_new_texture(c, kind.value);
}

void add_menu_items(PanelContext& c) {
    add_object_items(c);
    ImGui::Separator();
    add_light_items(c);
    ImGui::Separator();
    if (ImGui::MenuItem(ICON_FA_VIDEO "  Camera###Camera")) add_camera(c);
    if (ImGui::BeginMenu(ICON_FA_PALETTE "  Material###Material")) {
        add_material_items(c);
        ImGui::EndMenu();
    }
    if (ImGui::BeginMenu(ICON_FA_IMAGE "  Texture###Texture")) {
        add_texture_items(c);
        ImGui::EndMenu();
    }
}

}  // namespace tp
