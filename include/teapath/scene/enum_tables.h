// Names and labels of every enum that a user can choose from: JSON, command line and menus.
#pragma once

#include <teapath/core/enum_table.h>
#include <teapath/kernel/kinds.h>

namespace tp {

template <>
struct EnumTable<MaterialKind> {
    using E = MaterialKind;
    static constexpr std::array rows = {
        EnumRow<E>{E::Lambertian, "lambertian", "Lambertian"},
        EnumRow<E>{E::Metal, "metal", "Metal"},
        EnumRow<E>{E::Dielectric, "dielectric", "Dielectric"},
        EnumRow<E>{E::DiffuseLight, "diffuse_light", "Diffuse light"},
        EnumRow<E>{E::Principled, "principled", "Principled"},
        EnumRow<E>{E::Conductor, "conductor", "Conductor"}};
};

template <>
struct EnumTable<ConductorMetal> {
    using E = ConductorMetal;
    static constexpr std::array rows = {EnumRow<E>{E::Custom, "custom", "By its index"},
                                        EnumRow<E>{E::Gold, "gold", "Gold"},
                                        EnumRow<E>{E::Silver, "silver", "Silver"},
                                        EnumRow<E>{E::Copper, "copper", "Copper"},
                                        EnumRow<E>{E::Aluminium, "aluminium", "Aluminium"},
                                        EnumRow<E>{E::Brass, "brass", "Brass"},
                                        EnumRow<E>{E::Chromium, "chromium", "Chromium"},
                                        EnumRow<E>{E::Tungsten, "tungsten", "Tungsten"}};
};

template <>
struct EnumTable<MaskingRule> {
    using E = MaskingRule;
    static constexpr std::array rows = {EnumRow<E>{E::Correlated, "correlated", "Correlated"},
                                        EnumRow<E>{E::Separable, "separable", "Separable"}};
};

template <>
struct EnumTable<TextureKind> {
    using E = TextureKind;
    static constexpr std::array rows = {EnumRow<E>{E::Constant, "constant", "Constant"},
                                        EnumRow<E>{E::Checker, "checker", "Checker"},
                                        EnumRow<E>{E::Image, "image", "Image"},
                                        EnumRow<E>{E::Noise, "noise", "Noise"},
                                        EnumRow<E>{E::Marble, "marble", "Marble"},
                                        EnumRow<E>{E::Wood, "wood", "Wood"},
                                        EnumRow<E>{E::Brick, "brick", "Brick"}};
};

template <>
struct EnumTable<TextureSpace> {
    using E = TextureSpace;
    static constexpr std::array rows = {EnumRow<E>{E::Object, "object", "Object"},
                                        EnumRow<E>{E::World, "world", "World"},
                                        EnumRow<E>{E::Uv, "uv", "Texture coordinates"}};
};

template <>
struct EnumTable<TextureProjection> {
    using E = TextureProjection;
    static constexpr std::array rows = {EnumRow<E>{E::Uv, "uv", "Texture coordinates"},
                                        EnumRow<E>{E::Triplanar, "triplanar", "Triplanar"}};
};

template <>
struct EnumTable<NoisePattern> {
    using E = NoisePattern;
    static constexpr std::array rows = {EnumRow<E>{E::Gradient, "gradient", "Gradient noise"},
                                        EnumRow<E>{E::Fbm, "fbm", "Fractal (fBm)"},
                                        EnumRow<E>{E::Turbulence, "turbulence", "Turbulence"},
                                        EnumRow<E>{E::Ridged, "ridged", "Ridged"}};
};

template <>
struct EnumTable<Axis> {
    using E = Axis;
    static constexpr std::array rows = {EnumRow<E>{E::X, "x", "x"}, EnumRow<E>{E::Y, "y", "y"},
                                        EnumRow<E>{E::Z, "z", "z"}};
};

template <>
struct EnumTable<EmissionSide> {
    using E = EmissionSide;
    static constexpr std::array rows = {
        EnumRow<E>{E::Auto, "auto", "Automatic"}, EnumRow<E>{E::Front, "front", "Front"},
        EnumRow<E>{E::Outside, "outside", "Outside"}, EnumRow<E>{E::Both, "both", "Both sides"}};
};

template <>
struct EnumTable<FresnelRule> {
    using E = FresnelRule;
    static constexpr std::array rows = {EnumRow<E>{E::Exact, "exact", "Exact"},
                                        EnumRow<E>{E::Schlick, "schlick", "Schlick"}};
};

template <>
struct EnumTable<CheckerMode> {
    using E = CheckerMode;
    static constexpr std::array rows = {EnumRow<E>{E::Uv, "uv", "Texture coordinates"},
                                        EnumRow<E>{E::World, "world", "World space"}};
};

template <>
struct EnumTable<WrapMode> {
    using E = WrapMode;
    static constexpr std::array rows = {EnumRow<E>{E::Repeat, "repeat", "Repeat"},
                                        EnumRow<E>{E::Clamp, "clamp", "Clamp"},
                                        EnumRow<E>{E::Mirror, "mirror", "Mirror"}};
};

template <>
struct EnumTable<WrapModeV> {
    using E = WrapModeV;
    static constexpr std::array rows = {
        EnumRow<E>{E::AsU, "as_u", "As in u"}, EnumRow<E>{E::Repeat, "repeat", "Repeat"},
        EnumRow<E>{E::Clamp, "clamp", "Clamp"}, EnumRow<E>{E::Mirror, "mirror", "Mirror"}};
};

template <>
struct EnumTable<AlphaMode> {
    using E = AlphaMode;
    static constexpr std::array rows = {EnumRow<E>{E::Blend, "blend", "Opacity"},
                                        EnumRow<E>{E::Opaque, "opaque", "Ignored"},
                                        EnumRow<E>{E::Mask, "mask", "Cut-out"}};
};

template <>
struct EnumTable<TextureChannel> {
    using E = TextureChannel;
    static constexpr std::array rows = {
        EnumRow<E>{E::Red, "red", "Red"}, EnumRow<E>{E::Green, "green", "Green"},
        EnumRow<E>{E::Blue, "blue", "Blue"}, EnumRow<E>{E::Alpha, "alpha", "Alpha"}};
};

template <>
struct EnumTable<FilterMode> {
    using E = FilterMode;
    static constexpr std::array rows = {EnumRow<E>{E::Nearest, "nearest", "Nearest"},
                                        EnumRow<E>{E::Bilinear, "bilinear", "Bilinear"}};
};

template <>
struct EnumTable<ColorSpace> {
    using E = ColorSpace;
    static constexpr std::array rows = {EnumRow<E>{E::Auto, "auto", "Automatic"},
                                        EnumRow<E>{E::Srgb, "srgb", "sRGB"},
                                        EnumRow<E>{E::Linear, "linear", "Linear"}};
};

template <>
struct EnumTable<BackgroundKind> {
    using E = BackgroundKind;
    static constexpr std::array rows = {EnumRow<E>{E::Gradient, "gradient", "Gradient"},
                                        EnumRow<E>{E::Constant, "constant", "Constant"},
                                        EnumRow<E>{E::Image, "image", "Image"},
                                        EnumRow<E>{E::Sky, "sky", "Sky and sun"}};
};

template <>
struct EnumTable<BackdropKind> {
    using E = BackdropKind;
    static constexpr std::array rows = {EnumRow<E>{E::Same, "same", "The same"},
                                        EnumRow<E>{E::Constant, "constant", "Constant"},
                                        EnumRow<E>{E::Image, "image", "Image"}};
};

template <>
struct EnumTable<SunRule> {
    using E = SunRule;
    static constexpr std::array rows = {EnumRow<E>{E::Angles, "angles", "Angles"},
                                        EnumRow<E>{E::Place, "place", "Place and time"}};
};

template <>
struct EnumTable<ProjectionKind> {
    using E = ProjectionKind;
    static constexpr std::array rows = {
        EnumRow<E>{E::Perspective, "perspective", "Perspective"},
        EnumRow<E>{E::Orthographic, "orthographic", "Orthographic"},
        EnumRow<E>{E::Fisheye, "fisheye", "Fisheye"},
        EnumRow<E>{E::Equirectangular, "equirectangular", "Equirectangular"}};
};

template <>
struct EnumTable<ExposureRule> {
    using E = ExposureRule;
    static constexpr std::array rows = {EnumRow<E>{E::Stops, "stops", "Stops"},
                                        EnumRow<E>{E::Ev, "ev", "Exposure value"},
                                        EnumRow<E>{E::Photo, "photo", "Photo camera"}};
};

template <>
struct EnumTable<IntegratorKind> {
    using E = IntegratorKind;
    static constexpr std::array rows = {EnumRow<E>{E::Path, "path", "Path tracing"},
                                        EnumRow<E>{E::Book, "book", "Book (no light sampling)"},
                                        EnumRow<E>{E::Normal, "normal", "Normals"},
                                        EnumRow<E>{E::Flat, "flat", "Flat colour"}};
};

template <>
struct EnumTable<ScatterRule> {
    using E = ScatterRule;
    static constexpr std::array rows = {
        EnumRow<E>{E::Cosine, "cosine", "Cosine (Lambert)"},
        EnumRow<E>{E::Hemisphere, "hemisphere", "Uniform hemisphere"},
        EnumRow<E>{E::CosineCubed, "cosine_cubed", "Cosine cubed (point in ball)"}};
};

template <>
struct EnumTable<SamplerKind> {
    using E = SamplerKind;
    static constexpr std::array rows = {EnumRow<E>{E::Tea, "tea", "TEA"},
                                        EnumRow<E>{E::Sobol, "sobol", "Owen-scrambled Sobol"}};
};

template <>
struct EnumTable<LightRule> {
    using E = LightRule;
    static constexpr std::array rows = {EnumRow<E>{E::Tree, "tree", "By a tree of lights"},
                                        EnumRow<E>{E::Uniform, "uniform", "Each alike"}};
};

template <>
struct EnumTable<ToneCurve> {
    using E = ToneCurve;
    static constexpr std::array rows = {EnumRow<E>{E::Srgb, "srgb", "sRGB"},
                                        EnumRow<E>{E::Gamma2, "gamma2", "Gamma 2 (books)"},
                                        EnumRow<E>{E::Linear, "linear", "Linear"},
                                        EnumRow<E>{E::Aces, "aces", "ACES (fitted)"},
                                        EnumRow<E>{E::Agx, "agx", "AgX"},
                                        EnumRow<E>{E::Neutral, "neutral", "Khronos PBR Neutral"}};
};

}  // namespace tp
