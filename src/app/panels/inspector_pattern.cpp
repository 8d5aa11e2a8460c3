// Inspector of the textures that are made by formulae: noise, marble, wood, brick.
#include "inspector.h"
#include "texture_slots.h"

#include <teapath/core/tea.h>
#include <teapath/scene/enum_tables.h>

#include <limits>

namespace tp {
namespace {

void space_row(PropertyRows<Texture>& rows) {
    rows.choice(
        "Space",
        "Moves with the object, stays in the world, or lies on the surface by its coordinates",
        [](auto& t) -> auto& { return t.space; });
}

void hash_rows(PropertyRows<Texture>& rows) {
    rows.number(
        {.name = "Seed",
         .help = "Each gives another pattern",
         .speed = 0.1,
         .low = 0,
         .high = std::numeric_limits<int>::max()},
        [](auto& t) -> auto& { return t.seed; });
    rows.number(
        {.name = "TEA rounds",
         .help = "Of the hash: from 5 on no direction stands out, 2 are hardly noise",
         .speed = 0.05,
         .low = kMinNoiseRounds,
         .high = kMaxTeaRounds},
        [](auto& t) -> auto& { return t.tea_rounds; });
}

void octave_rows(PropertyRows<Texture>& rows) {
    rows.number(
        {.name = "Octaves",
         .help = "Layers of noise, each finer than the last",
         .speed = 0.05,
         .low = 1,
         .high = kMaxOctaves},
        [](auto& t) -> auto& { return t.octaves; });
    rows.number(
        {.name = "Lacunarity",
         .help = "How much finer each octave is",
         .speed = 0.01,
         .low = 1,
         .high = 8},
        [](auto& t) -> auto& { return t.lacunarity; });
    rows.number(
        {.name = "Gain", .help = "How strong each octave is", .speed = 0.003, .low = 0, .high = 1},
        [](auto& t) -> auto& { return t.gain; });
}

void scale_row(PropertyRows<Texture>& rows, const char* help) {
    rows.number(
        {.name = "Scale", .help = help, .speed = 0.01, .relative = true},
        [](auto& t) -> auto& { return t.scale; });
}

void distortion_row(PropertyRows<Texture>& rows, const char* help) {
    rows.number(
        {.name = "Distortion", .help = help, .speed = 0.01, .low = 0, .high = 100},
        [](auto& t) -> auto& { return t.distortion; });
}

void noise_rows(PropertyRows<Texture>& rows) {
    slot(
        rows, {.name = "Low", .help = "Colour where the noise is low"},
        [](auto& t) -> auto& { return t.low; }, rows.active().id);
    slot(
        rows, {.name = "High", .help = "Colour where the noise is high"},
        [](auto& t) -> auto& { return t.high; }, rows.active().id);
    rows.choice(
        "Pattern", "What is made of the noise", [](auto& t) -> auto& { return t.pattern; });
    rows.number(
        {.name = "Contrast",
         .help = "About the middle of the two colours",
         .speed = 0.01,
         .low = 0,
         .high = 100},
        [](auto& t) -> auto& { return t.contrast; });
    space_row(rows);
    scale_row(rows, "Cells of the noise in a unit of its space, along x, y and z");
    if (rows.active().pattern != NoisePattern::Gradient) octave_rows(rows);
    hash_rows(rows);
}

void marble_rows(PropertyRows<Texture>& rows) {
    slot(
        rows, {.name = "Stone", .help = "Colour between the veins"},
        [](auto& t) -> auto& { return t.stone; }, rows.active().id);
    slot(
        rows, {.name = "Vein", .help = "Colour of the veins"},
        [](auto& t) -> auto& { return t.vein; }, rows.active().id);
    rows.choice(
        "Axis", "Across the layers", [](auto& t) -> auto& { return t.axis; });
    distortion_row(rows, "How much turbulence bends the layers");
    rows.number(
        {.name = "Vein power",
         .help = "The higher, the narrower the veins",
         .speed = 0.01,
         .low = 0.1,
         .high = 100,
         .relative = true},
        [](auto& t) -> auto& { return t.vein_power; });
    space_row(rows);
    scale_row(rows, "Veins in a unit of its space");
    octave_rows(rows);
    hash_rows(rows);
}

void wood_rows(PropertyRows<Texture>& rows) {
    slot(
        rows, {.name = "Early wood", .help = "Colour of the wide, light part of a ring"},
        [](auto& t) -> auto& { return t.early; }, rows.active().id);
    slot(
        rows, {.name = "Late wood", .help = "Colour of the narrow, dark part of a ring"},
        [](auto& t) -> auto& { return t.late; }, rows.active().id);
    rows.choice(
        "Axis", "Along the trunk", [](auto& t) -> auto& { return t.axis; });
    distortion_row(rows, "How uneven the rings are, in their widths");
    rows.number(
        {.name = "Grain", .help = "How dark the fibres are", .speed = 0.003, .low = 0, .high = 1},
        [](auto& t) -> auto& { return t.grain; });
    space_row(rows);
    scale_row(rows, "Rings in a unit of its space");
    octave_rows(rows);
    hash_rows(rows);
}

void brick_rows(PropertyRows<Texture>& rows) {
    slot(
        rows, {.name = "Brick", .help = "Colour of the bricks"},
        [](auto& t) -> auto& { return t.brick; }, rows.active().id);
    slot(
        rows, {.name = "Mortar", .help = "Colour of the joints"},
        [](auto& t) -> auto& { return t.mortar; }, rows.active().id);
    rows.number(
        {.name = "Brick size",
         .help = "Width and height with the mortar, in units of its space",
         .speed = 0.01,
         .low = 1e-6,
         .high = 1e6,
         .relative = true},
        [](auto& t) -> auto& { return t.brick_size; });
    rows.number(
        {.name = "Mortar width",
         .help = "In the same units",
         .speed = 0.01,
         .low = 0,
         .high = 1e6,
         .relative = true},
        [](auto& t) -> auto& { return t.mortar_width; });
    rows.number(
        {.name = "Mortar blend",
         .help = "Share of that width by which mortar runs into the brick; 0 is sharp",
         .speed = 0.003,
         .low = 0,
         .high = 10},
        [](auto& t) -> auto& { return t.mortar_blend; });
    rows.number(
        {.name = "Row offset",
         .help = "Of a row from the one below, in bricks",
         .speed = 0.003,
         .low = 0,
         .high = 1},
        [](auto& t) -> auto& { return t.row_offset; });
    rows.number(
        {.name = "Variation",
         .help = "How much darker single bricks are",
         .speed = 0.003,
         .low = 0,
         .high = 1},
        [](auto& t) -> auto& { return t.variation; });
    space_row(rows);
    hash_rows(rows);
}

}  // namespace

void pattern_rows(PropertyRows<Texture>& rows) {
    switch (rows.active().kind) {
        case TextureKind::Noise: noise_rows(rows); break;
        case TextureKind::Marble: marble_rows(rows); break;
        case TextureKind::Wood: wood_rows(rows); break;
        case TextureKind::Brick: brick_rows(rows); break;
        case TextureKind::Constant:
        case TextureKind::Checker:
        case TextureKind::Image: break;
    }
}

}  // namespace tp
