// Inspector of materials: presets and every parameter.
#include "inspector.h"
#include "texture_slots.h"

#include <teapath/editor/material_presets.h>
#include <teapath/scene/enum_tables.h>

#include <icons_font_awesome_6.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

PropertyRows<Material> property_rows(PanelContext& c, const std::vector<MaterialId>& ids) {
    std::vector<const Material*> things;
    std::vector<MaterialId> known;
    for (const MaterialId id : ids)
        if (const Material* m = find(c.document.scene(), id)) {
            things.push_back(m);
            known.push_back(id);
        }
    const Material& active = *things.back();
    const std::string what =
        known.size() == 1 ? display_name(active) : fmt::format("{} materials", known.size());
    const Material standard = new_material(active.kind);
    return PropertyRows<Material>(
        c, what, fmt::format("material {}", active.id.value), std::move(things),
        [known](Scene& s, size_t i) { return find_material(s, known[i]); }, standard);
}

void kind_rows(PropertyRows<Material>& rows) {
    const auto kind_of = [](auto& m) -> auto& {
        return m.kind;
    };
    MaterialKind kind = rows.active().kind;
    if (!ui::row("Kind", kind, "How the surface scatters", static_cast<MaterialKind*>(nullptr),
                 !rows.is_same(kind_of)))
        return;
    rows.apply("Kind", false, [&](Material& m) {
        // A colour that nobody chose becomes what suits the new kind.
        const bool is_untouched = m.color == new_material(m.kind).color;
        m.kind = kind;
        if (is_untouched) m.color = new_material(kind).color;
    });
}

void conductor_rows(PropertyRows<Material>& rows) {
    rows.choice(
        "Metal", "Whose index of refraction it has", [](auto& m) -> auto& { return m.metal; });
    if (rows.active().metal != ConductorMetal::Custom) return;
    rows.number(
        {.name = "Index",
         .help = "Real part of the index of refraction, of red, green and blue light",
         .speed = 0.01,
         .low = 0.01,
         .high = 100},
        [](auto& m) -> auto& { return m.eta; });
    rows.number(
        {.name = "Extinction",
         .help = "Imaginary part of the index of refraction, of red, green and blue light",
         .speed = 0.01,
         .low = 0,
         .high = 100},
        [](auto& m) -> auto& { return m.k; });
}

void facet_rows(PropertyRows<Material>& rows) {
    slot(
        rows,
        {.name = "Roughness",
         .help = "0 is smooth; GGX's alpha is its square",
         .speed = 0.003,
         .low = 0,
         .high = 1},
        [](auto& m) -> auto& { return m.roughness; });
    if (!(rows.active().roughness.value > 0)) return;
    rows.choice(
        "Masking", "How facets hide each other: with heights correlated, or each way for itself",
        [](auto& m) -> auto& { return m.masking; });
    rows.toggle(
        "Compensation", "Gives back the energy that rough surfaces lose by single scattering",
        [](auto& m) -> auto& { return m.surface.compensation; });
}

void scatter_rows(PropertyRows<Material>& rows) {
    const MaterialKind kind = rows.active().kind;
    const char* help =
        kind == MaterialKind::Metal        ? "Share of light that is reflected"
        : kind == MaterialKind::Dielectric ? "Tint of what is reflected and let through"
        : kind == MaterialKind::Conductor  ? "Tint of the reflection; white is the pure metal"
        : kind == MaterialKind::Principled
            ? "Base colour: of the diffuse light, of metal, of what is let through"
            : "Share of light that is scattered";
    slot(
        rows, {.name = "Colour", .help = help}, [](auto& m) -> auto& { return m.color; });
    if (kind == MaterialKind::Metal)
        rows.number(
            {.name = "Fuzz", .help = "Blurs the reflection", .speed = 0.003, .low = 0, .high = 1},
            [](auto& m) -> auto& { return m.fuzz; });
    if (kind == MaterialKind::Principled) principled_rows(rows);
    if (kind == MaterialKind::Conductor) conductor_rows(rows);
    if (kind == MaterialKind::Conductor || kind == MaterialKind::Dielectric) facet_rows(rows);
    if (kind != MaterialKind::Dielectric) return;
    rows.number(
        {.name = "Index",
         .help = "Index of refraction behind the surface: water 1.33, glass 1.5, diamond 2.42",
         .speed = 0.003,
         .low = 0.01,
         .high = 100},
        [](auto& m) -> auto& { return m.ior; });
    rows.number(
        {.name = "Outside index",
         .help = "Index of refraction before the surface, as of water around a bubble",
         .speed = 0.003,
         .low = 0.01,
         .high = 100},
        [](auto& m) -> auto& { return m.exterior_ior; });
    rows.choice(
        "Fresnel", "How much is reflected at each angle: the exact law, or Schlick's",
        [](auto& m) -> auto& { return m.fresnel; });
}

// The colour of a black body, as the temperature of the emission; other colours have none.
void temperature_row(PropertyRows<Material>& rows) {
    const TexturedColor& emission = rows.active().emission;
    if (emission.texture) return;
    const std::optional<double> known = temperature_of(emission.color);
    double kelvin = known ? std::round(*known) : 6500;
    const double standard = 6500;
    const unsigned changed = ui::row({.name = "Temperature",
                                      .help = "Sets the emission to the colour of a black body: "
                                              "candle 1,850, light bulb 2,700, daylight 6,500",
                                      .speed = 10,
                                      .low = 1700,
                                      .high = 20000,
                                      .decimals = 0,
                                      .unit = " K",
                                      .relative = true},
                                     &kelvin, known ? &standard : nullptr, 1, known ? 0u : 1u);
    if (changed == 0) return;
    rows.apply("Temperature", true, [&](Material& m) {
        m.emission.color = black_body_color(kelvin);
        m.emission.texture = {};
    });
}

void emission_rows(PropertyRows<Material>& rows) {
    const bool is_light = rows.active().kind == MaterialKind::DiffuseLight;
    if (!is_light)
        rows.toggle(
            "Emits", "Gives light beside scattering it", [](auto& m) -> auto& { return m.emits; });
    if (!is_light && !rows.active().emits) return;
    slot(
        rows, {.name = "Emission", .help = "Radiance of each channel"},
        [](auto& m) -> auto& { return m.emission; });
    temperature_row(rows);
    rows.number(
        {.name = "Strength",
         .help = "Multiplies the emission",
         .speed = 0.02,
         .low = 0,
         .high = 1e6,
         .relative = true},
        [](auto& m) -> auto& { return m.strength; });
    rows.choice(
        "Emits on", "Which side gives light; automatic is the outer one",
        [](auto& m) -> auto& { return m.side; });
    rows.number(
        {.name = "Spot angle",
         .help = "Across the cone about the normal that light is given in; 180\xc2\xb0 is all",
         .speed = 0.2,
         .low = 0.1,
         .high = 180,
         .decimals = 1,
         .unit = "\xc2\xb0"},
        [](auto& m) -> auto& { return m.spot_angle; });
    if (rows.active().spot_angle < 180)
        rows.number(
            {.name = "Spot blend",
             .help = "Share of the cone over which its edge fades",
             .speed = 0.003,
             .low = 0,
             .high = 1},
            [](auto& m) -> auto& { return m.spot_blend; });
}

void opacity_rows(PropertyRows<Material>& rows) {
    rows.choice(
        "Alpha", "What the alpha of the colour's image and of a mesh's vertices does",
        [](auto& m) -> auto& { return m.alpha; });
    if (rows.active().alpha == AlphaMode::Mask)
        rows.number(
            {.name = "Cut-off",
             .help = "Alpha below lets all light through",
             .speed = 0.003,
             .low = 0,
             .high = 1},
            [](auto& m) -> auto& { return m.alpha_cutoff; });
    rows.number(
        {.name = "Opacity",
         .help = "Share of light that meets the surface; the rest goes straight on",
         .speed = 0.003,
         .low = 0,
         .high = 1},
        [](auto& m) -> auto& { return m.opacity; });
    if (rows.active().opacity < 1)
        rows.color(
            "Pass colour", "Colour of what goes straight on",
            [](auto& m) -> auto& { return m.pass_through; });
}

void preset_menu(PropertyRows<Material>& rows) {
    ui::begin_row("Preset", "Takes every value of a real material; the name stays");
    if (!ImGui::BeginCombo("##preset", "Choose\xe2\x80\xa6", ImGuiComboFlags_HeightLarge)) return;
    const char* group = "";
    for (const MaterialPreset& preset : material_presets()) {
        if (std::string_view(group) != preset.group) ImGui::SeparatorText(group = preset.group);
        if (ImGui::Selectable(preset.material.name.c_str()))
            rows.apply(fmt::format("Preset {}", preset.material.name).c_str(), false,
                       [&](Material& m) { m = with_preset(m, preset); });
    }
    ImGui::EndCombo();
}

}  // namespace

void material_rows(PanelContext& c, const std::vector<MaterialId>& ids) {
    const auto is_known = [&](MaterialId id) { return find(c.document.scene(), id) != nullptr; };
    if (std::none_of(ids.begin(), ids.end(), is_known)) {
        ImGui::TextDisabled("The default: grey, Lambertian.");
        return;
    }
    const ScenePtr scene = c.document.snapshot();
    PropertyRows<Material> rows = property_rows(c, ids);
    if (!ui::begin_rows("material")) return;
    kind_rows(rows);
    preset_menu(rows);
    if (rows.is_same([](auto& m) -> auto& { return m.kind; })) {
        if (rows.active().kind != MaterialKind::DiffuseLight) scatter_rows(rows);
        emission_rows(rows);
    }
    opacity_rows(rows);
    ui::end_rows();
}

void material_inspector(PanelContext& c, const std::vector<SceneItem>& items) {
    std::vector<MaterialId> ids;
    for (const SceneItem item : items)
        ids.push_back({item.id});
    size_t users = 0;
    for (const Object& o : c.document.scene().objects)
        if (o.material == ids.back()) ++users;
    inspector_header(c, items, ICON_FA_PALETTE,
                     users == 0   ? "Material, not used"
                     : users == 1 ? "Material of one object"
                                  : fmt::format("Material of {} objects", users));
    material_rows(c, ids);
}

}  // namespace tp
