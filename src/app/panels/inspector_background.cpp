// Inspector of the background: colours, an image, a sky with its sun, and what the camera sees.
#include "inspector.h"

#include <teapath/editor/material_presets.h>
#include <teapath/scene/enum_tables.h>

#include <icons_font_awesome_6.h>

namespace tp {
namespace {

void preset_row(PropertyRows<Background>& rows) {
    ui::begin_row("Preset", "A sky to start from");
    if (!ImGui::BeginCombo("##preset", "Choose\xe2\x80\xa6")) return;
    for (const SkyPreset& preset : sky_presets())
        if (ImGui::Selectable(preset.name))
            rows.apply(fmt::format("Preset {}", preset.name).c_str(), false, [&](Background& b) {
                const ImageFile image = b.file;
                b = preset.background;
                b.file = image;  // is kept for a way back
            });
    ImGui::EndCombo();
}

ui::NumberRow degrees(const char* name, const char* help, double low, double high) {
    return {.name = name,
            .help = help,
            .speed = 0.2,
            .low = low,
            .high = high,
            .decimals = 1,
            .unit = "\xc2\xb0"};
}

void place_rows(PropertyRows<Background>& rows) {
    rows.number(
        degrees("Latitude", "North is positive", -90, 90),
        [](auto& b) -> auto& { return b.sky.latitude; });
    rows.number(
        degrees("Longitude", "East is positive", -180, 180),
        [](auto& b) -> auto& { return b.sky.longitude; });
    rows.number(
        {.name = "Day", .help = "Of the year", .speed = 0.2, .low = 1, .high = 366, .decimals = 0},
        [](auto& b) -> auto& { return b.sky.day; });
    rows.number(
        {.name = "Hour",
         .help = "Of the day in universal time",
         .speed = 0.02,
         .low = 0,
         .high = 24,
         .unit = " h"},
        [](auto& b) -> auto& { return b.sky.hour; });
    const SunPosition sun = sun_position(rows.active().sky);
    ui::row_text("Sun at", fmt::format("{:.1f}\xc2\xb0 high, {:.1f}\xc2\xb0 from north",
                                       sun.elevation, sun.azimuth));
}

void sky_rows(PropertyRows<Background>& rows) {
    rows.choice(
        "Sun by", "Where the sun stands: as you say, or as it is seen from a place on the earth",
        [](auto& b) -> auto& { return b.sky.sun_by; });
    if (rows.active().sky.sun_by == SunRule::Place) {
        place_rows(rows);
    } else {
        rows.number(
            degrees("Elevation", "Of the sun above the horizon", -90, 90),
            [](auto& b) -> auto& { return b.sky.sun_elevation; });
        rows.number(
            degrees("Azimuth", "Of the sun, from north (-z) to the east (+x)", -360, 360),
            [](auto& b) -> auto& { return b.sky.sun_azimuth; });
    }
    rows.number(
        {.name = "Sun size",
         .help = "Of its disk; a larger one has softer shadows. The real one has 0.53\xc2\xb0",
         .speed = 0.01,
         .low = 0.01,
         .high = 90,
         .unit = "\xc2\xb0",
         .relative = true},
        [](auto& b) -> auto& { return b.sky.sun_size; });
    rows.number(
        {.name = "Sun strength",
         .help = "Times the light of the sun; 0 is a sky without its disk",
         .speed = 0.005,
         .low = 0,
         .high = 1e6,
         .relative = true},
        [](auto& b) -> auto& { return b.sky.sun_strength; });
    rows.number(
        {.name = "Haze", .help = "Times that of clear air", .speed = 0.01, .low = 0, .high = 20},
        [](auto& b) -> auto& { return b.sky.haze; });
    rows.color(
        "Ground", "Albedo of the earth below the horizon",
        [](auto& b) -> auto& { return b.sky.ground; });
}

void image_rows(PropertyRows<Background>& rows) {
    row_image(rows.context(), "File", "An image of all directions, twice as wide as high",
              rows.active().file, background_item());
    rows.choice(
        "Values are", "Automatic: sRGB for 8 and 16 bits, linear for float",
        [](auto& b) -> auto& { return b.color_space; });
    rows.number(
        degrees("Rotation", "About the vertical axis", -360, 360),
        [](auto& b) -> auto& { return b.rotation; });
}

void backdrop_rows(PropertyRows<Background>& rows) {
    rows.choice(
        "Backdrop", "What the camera itself sees of the background",
        [](auto& b) -> auto& { return b.backdrop; });
    if (rows.active().backdrop == BackdropKind::Constant)
        rows.color(
            "Backdrop colour", "Radiance that the camera sees",
            [](auto& b) -> auto& { return b.backdrop_color; });
    if (rows.active().backdrop == BackdropKind::Image)
        ui::row_text("Backdrop image", rows.active().backdrop_file.path,
                     "Named in the scene file by backdrop_file");
}

void background_rows(PropertyRows<Background>& rows) {
    rows.choice(
        "Kind", "What is seen where nothing is hit", [](auto& b) -> auto& { return b.kind; });
    preset_row(rows);
    const BackgroundKind kind = rows.active().kind;
    switch (kind) {
        case BackgroundKind::Gradient:
            rows.color(
                "Top", "Radiance straight up", [](auto& b) -> auto& { return b.top; });
            rows.color(
                "Bottom", "Radiance straight down", [](auto& b) -> auto& { return b.bottom; });
            break;
        case BackgroundKind::Constant:
            rows.color(
                "Colour", "Radiance from everywhere", [](auto& b) -> auto& { return b.color; });
            break;
        case BackgroundKind::Image: image_rows(rows); break;
        case BackgroundKind::Sky: sky_rows(rows); break;
    }
    if (kind == BackgroundKind::Image || kind == BackgroundKind::Sky)
        rows.color(
            "Tint", "Multiplies the radiance", [](auto& b) -> auto& { return b.tint; });
    rows.number(
        {.name = "Strength",
         .help = "Multiplies the radiance",
         .speed = 0.005,
         .low = 0,
         .high = 1e6,
         .relative = true},
        [](auto& b) -> auto& { return b.strength; });
    backdrop_rows(rows);
}

}  // namespace

void background_inspector(PanelContext& c) {
    inspector_header(c, {background_item()}, ICON_FA_CLOUD_SUN, "Light from outside of the scene");
    const ScenePtr scene = c.document.snapshot();
    PropertyRows<Background> rows(c, "background", "background", {&scene->background},
                                  [](Scene& s, size_t) { return &s.background; });
    if (!ui::begin_rows("background")) return;
    background_rows(rows);
    ui::end_rows();
}

}  // namespace tp
