// Textures of the document, and a colour that may come from one.
#pragma once

#include <teapath/core/math.h>
#include <teapath/kernel/kinds.h>
#include <teapath/scene/ids.h>
#include <teapath/scene/image.h>

#include <memory>
#include <string>

namespace tp {

/// A constant colour, or a texture in its place.
struct TexturedColor {
    Double3 color{0.5, 0.5, 0.5};  // linear; read where there is no texture
    TextureId texture;

    friend bool operator==(const TexturedColor&, const TexturedColor&) = default;
};

/// A number, multiplied by a channel of a texture where there is one.
struct TexturedNumber {
    double value = 0;
    TextureId texture;
    TextureChannel channel = TextureChannel::Red;

    friend bool operator==(const TexturedNumber&, const TexturedNumber&) = default;
};

/// An image file and its pixels. Equal when the files are: pixels are loaded, not edited.
struct ImageFile {
    std::string path;                    // as the scene file says it, relative to that file
    std::shared_ptr<const Image> image;  // null: missing, shown as cyan

    friend bool operator==(const ImageFile& a, const ImageFile& b) { return a.path == b.path; }
};

struct Texture {
    TextureId id;
    std::string name;  // empty: written inline where it is used
    TextureKind kind = TextureKind::Constant;

    // Constant
    Double3 color{0.5, 0.5, 0.5};  // linear

    // Checker: each field may be a texture again
    TexturedColor even{{0.9, 0.9, 0.9}, {}};
    TexturedColor odd{{0.2, 0.3, 0.1}, {}};
    CheckerMode mode = CheckerMode::Uv;
    Double2 cells{8, 8};    // Uv: cells over the unit square
    double frequency = 10;  // World: radians per scene unit

    // Image
    ImageFile file;
    WrapMode wrap = WrapMode::Repeat;
    FilterMode filter = FilterMode::Bilinear;
    ColorSpace color_space = ColorSpace::Auto;
    WrapModeV wrap_v = WrapModeV::AsU;
    int uv_set = 0;           // of a mesh, below kUvSets
    Double2 repeat{1, 1};     // multiplies uv
    double uv_rotation = 0;   // degrees, after `repeat`, as KHR_texture_transform turns
    Double2 uv_offset{0, 0};  // added last
    Double3 tint{1, 1, 1};    // multiplies the colour
    TextureProjection projection = TextureProjection::Uv;
    double sharpness = 4;  // Triplanar: of the edges between its sides, 0.1 to 64

    // Noise, Marble, Wood, Brick: two colours, each of which may be a texture again
    TexturedColor low{{0, 0, 0}, {}};
    TexturedColor high{{1, 1, 1}, {}};
    TexturedColor stone{{0.85, 0.83, 0.8}, {}};
    TexturedColor vein{{0.12, 0.11, 0.13}, {}};
    TexturedColor early{{0.5, 0.26, 0.11}, {}};
    TexturedColor late{{0.2, 0.08, 0.03}, {}};
    TexturedColor brick{{0.4, 0.12, 0.07}, {}};
    TexturedColor mortar{{0.55, 0.52, 0.47}, {}};

    // Where the pattern lies; of triplanar images too
    TextureSpace space = TextureSpace::Object;
    Double3 scale{4, 4, 4};  // cells, veins, rings in a unit of its space
    Axis axis = Axis::Y;     // Marble: across the layers; Wood: along the trunk
    int seed = 0;            // 0 or more
    int tea_rounds = 6;      // kMinNoiseRounds to kMaxTeaRounds

    // The noise of Noise, Marble and Wood
    NoisePattern pattern = NoisePattern::Fbm;
    int octaves = 5;        // 1 to kMaxOctaves
    double lacunarity = 2;  // frequency of an octave over that of the last, 1 to 8
    double gain = 0.5;      // its weight likewise, 0 to 1
    double contrast = 1;    // Noise: about the middle of the colours, 0 to 100
    double distortion = 1;  // Marble, Wood: of layers or rings by noise, in their widths, 0 to 100
    double vein_power = 3;  // Marble: veins are the narrower, 0.1 to 100
    double grain = 0.3;     // Wood: how dark its fibres are, 0 to 1

    // Brick
    Double2 brick_size{0.25, 0.08};  // width and height with the mortar, units of its space
    double mortar_width = 0.012;     // units of its space
    double mortar_blend = 0.3;       // share of that width by which it runs into the brick, 0 to 10
    double row_offset = 0.5;         // of a row from the one below, in bricks, 0 to 1
    double variation = 0.4;          // how much darker single bricks are, 0 to 1

    ModelPart part;

    friend bool operator==(const Texture&, const Texture&) = default;
};

}  // namespace tp
