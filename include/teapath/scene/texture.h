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
    ModelPart part;

    friend bool operator==(const Texture&, const Texture&) = default;
};

}  // namespace tp
