// Textures made by formulae, for the tests of scene files.
#pragma once

#include <teapath/scene/enum_tables.h>
#include <teapath/scene/texture.h>

#include <doctest/doctest.h>

namespace tp::test {

/// Gives every number of the pattern, and the projection of an image, a value within its range;
/// below(n) is a random number from 0 to n - 1.
template <class Below>
void randomize_pattern(Texture& t, Double3 scale, const Below& below) {
    t.scale = scale;
    const auto any = [&]<class Enum>() {
        const auto& rows = EnumTable<Enum>::rows;
        return rows[below(rows.size())].value;
    };
    t.projection = any.template operator()<TextureProjection>();
    t.space = any.template operator()<TextureSpace>();
    if (t.projection == TextureProjection::Triplanar) t.space = TextureSpace::World;
    t.sharpness = 1 + below(9);
    t.axis = any.template operator()<Axis>();
    t.seed = static_cast<int>(below(1u << 31));
    t.tea_rounds = 2 + static_cast<int>(below(31));
    t.pattern = any.template operator()<NoisePattern>();
    t.octaves = 1 + static_cast<int>(below(16));
    t.lacunarity = 1 + 0.5 * below(4);
    t.gain = 0.25 * below(5);
    t.contrast = below(9);
    t.distortion = below(9);
    t.vein_power = 1 + below(9);
    t.grain = 0.25 * below(5);
    t.brick_size = {0.1 * (1 + below(9)), 0.1};
    t.mortar_width = 0.01 * below(9);
    t.mortar_blend = 0.5 * below(3);
    t.row_offset = 0.25 * below(5);
    t.variation = 0.25 * below(5);
}

/// Compares what textures of the same kind, noise, marble, wood or brick, have beside their
/// colours.
inline void check_same_pattern(const Texture& x, const Texture& y) {
    CHECK((x.space == y.space && x.seed == y.seed && x.tea_rounds == y.tea_rounds));
    if (x.kind == TextureKind::Brick) {
        CHECK((x.brick_size == y.brick_size && x.mortar_width == y.mortar_width &&
               x.mortar_blend == y.mortar_blend && x.row_offset == y.row_offset &&
               x.variation == y.variation));
        return;
    }
    CHECK((x.scale == y.scale && x.octaves == y.octaves && x.lacunarity == y.lacunarity &&
           x.gain == y.gain));
    if (x.kind == TextureKind::Noise) CHECK((x.pattern == y.pattern && x.contrast == y.contrast));
    if (x.kind != TextureKind::Noise) CHECK((x.axis == y.axis && x.distortion == y.distortion));
    if (x.kind == TextureKind::Marble) CHECK(x.vein_power == y.vein_power);
    if (x.kind == TextureKind::Wood) CHECK(x.grain == y.grain);
}

}  // namespace tp::test
