// Inspector of the principled surface: its lobes from the base outwards.
#include "inspector.h"
#include "texture_slots.h"

namespace tp {
namespace {

ui::NumberRow share(const char* name, const char* help) {
    return {.name = name, .help = help, .speed = 0.003, .low = 0, .high = 1};
}

void base_rows(PropertyRows<Material>& rows) {
    slot(
        rows, share("Metallic", "0 is a dielectric, 1 a metal"),
        [](auto& m) -> auto& { return m.surface.metallic; });
    slot(
        rows, share("Roughness", "0 is smooth; GGX's alpha is its square"),
        [](auto& m) -> auto& { return m.surface.roughness; });
    rows.number(
        {.name = "Index",
         .help = "Index of refraction of the dielectric: water 1.33, plastic 1.5, diamond 2.42",
         .speed = 0.003,
         .low = 1,
         .high = 100},
        [](auto& m) -> auto& { return m.ior; });
    slot(
        rows, share("Specular", "Strength of the dielectric's reflection"),
        [](auto& m) -> auto& { return m.surface.specular; });
    slot(
        rows,
        {.name = "Specular colour", .help = "Tint of the dielectric's reflection seen head-on"},
        [](auto& m) -> auto& { return m.surface.specular_color; });
    slot(
        rows, share("Anisotropy", "Stretches reflections along the tangent, as of brushed metal"),
        [](auto& m) -> auto& { return m.surface.anisotropy; });
    if (rows.active().surface.anisotropy.value > 0)
        rows.number(
            {.name = "Direction",
             .help = "From the tangent, counter-clockwise",
             .speed = 0.5,
             .decimals = 1,
             .unit = "\xc2\xb0"},
            [](auto& m) -> auto& { return m.surface.anisotropy_rotation; });
    slot(
        rows, {.name = "Normal map", .help = "An image of normals in tangent space"},
        [](auto& m) -> auto& { return m.surface.normal; });
    if (rows.active().surface.normal)
        rows.number(
            {.name = "Normal scale", .help = "Exaggerates or flattens the map", .speed = 0.01},
            [](auto& m) -> auto& { return m.surface.normal_scale; });
    slot(
        rows, {.name = "Bump map", .help = "A texture whose luminance is a height"},
        [](auto& m) -> auto& { return m.surface.bump; });
    if (rows.active().surface.bump)
        rows.number(
            {.name = "Bump height",
             .help = "In scene units, where the texture is white; negative: it is a depth",
             .speed = 0.01,
             .relative = true},
            [](auto& m) -> auto& { return m.surface.bump_scale; });
}

void transmission_rows(PropertyRows<Material>& rows) {
    slot(
        rows, share("Transmission", "Share of light that is refracted instead of scattered"),
        [](auto& m) -> auto& { return m.surface.transmission; });
    if (rows.active().surface.transmission.value > 0) {
        rows.toggle(
            "Thin", "A wall without an inside: light goes straight on",
            [](auto& m) -> auto& { return m.surface.thin; });
        if (!rows.active().surface.thin) {
            rows.number(
                {.name = "Absorbs over",
                 .help = "Distance in scene units until white light has the colour below; 0: never",
                 .speed = 0.01,
                 .low = 0,
                 .relative = true},
                [](auto& m) -> auto& { return m.surface.attenuation_distance; });
            rows.color(
                "Absorbs to", "What is left of white light after that distance",
                [](auto& m) -> auto& { return m.surface.attenuation_color; });
            rows.number(
                {.name = "Dispersion",
                 .help = "20 over the Abbe number: 0.36 is crown glass, 0.63 flint, 0 is none",
                 .speed = 0.003,
                 .low = 0,
                 .high = 100},
                [](auto& m) -> auto& { return m.surface.dispersion; });
        }
    }
    slot(
        rows, share("Translucency", "Share of the diffuse light that goes through, as in leaves"),
        [](auto& m) -> auto& { return m.surface.diffuse_transmission; });
    if (rows.active().surface.diffuse_transmission.value > 0)
        slot(
            rows,
            {.name = "Translucent colour", .help = "Colour of the diffuse light that goes through"},
            [](auto& m) -> auto& { return m.surface.diffuse_transmission_color; });
}

void film_rows(PropertyRows<Material>& rows) {
    slot(
        rows, share("Iridescence", "A thin film with the colours of soap bubbles"),
        [](auto& m) -> auto& { return m.surface.iridescence; });
    if (!(rows.active().surface.iridescence.value > 0)) return;
    rows.number(
        {.name = "Film index",
         .help = "Index of refraction of the film",
         .speed = 0.003,
         .low = 1,
         .high = 10},
        [](auto& m) -> auto& { return m.surface.iridescence_ior; });
    ui::NumberRow thickness{.name = "Film thickness",
                            .help = "In nanometres, where its texture is 1",
                            .speed = 1,
                            .low = 0,
                            .high = 1e5,
                            .decimals = 0,
                            .unit = " nm"};
    slot(
        rows, thickness, [](auto& m) -> auto& { return m.surface.iridescence_thickness; });
    if (!rows.active().surface.iridescence_thickness.texture) return;
    thickness.name = "Film at least";
    thickness.help = "In nanometres, where its texture is 0";
    rows.number(
        thickness, [](auto& m) -> auto& { return m.surface.iridescence_thickness_low; });
}

void layer_rows(PropertyRows<Material>& rows) {
    slot(
        rows, share("Coat", "A clear varnish of index 1.5 on top"),
        [](auto& m) -> auto& { return m.surface.coat; });
    if (rows.active().surface.coat.value > 0) {
        slot(
            rows, share("Coat roughness", "Roughness of the varnish"),
            [](auto& m) -> auto& { return m.surface.coat_roughness; });
        slot(
            rows, {.name = "Coat normal", .help = "An image of the varnish's normals"},
            [](auto& m) -> auto& { return m.surface.coat_normal; });
        if (rows.active().surface.coat_normal)
            rows.number(
                {.name = "Coat scale",
                 .help = "Exaggerates or flattens the varnish's map",
                 .speed = 0.01},
                [](auto& m) -> auto& { return m.surface.coat_normal_scale; });
    }
    film_rows(rows);
    slot(
        rows, {.name = "Sheen", .help = "Colour of the soft rim of cloth; black is none"},
        [](auto& m) -> auto& { return m.surface.sheen_color; });
    const TexturedColor& sheen = rows.active().surface.sheen_color;
    if (sheen.texture || sheen.color != Double3(0))
        slot(
            rows, share("Sheen roughness", "Width of the rim"),
            [](auto& m) -> auto& { return m.surface.sheen_roughness; });
}

}  // namespace

void principled_rows(PropertyRows<Material>& rows) {
    base_rows(rows);
    transmission_rows(rows);
    layer_rows(rows);
    rows.toggle(
        "Compensation", "Gives back the energy that rough surfaces lose by single scattering",
        [](auto& m) -> auto& { return m.surface.compensation; });
}

}  // namespace tp
