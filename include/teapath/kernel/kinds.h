// The enums that scene, kernels, files and panels share. Names and labels: scene/enum_tables.h.
#pragma once

#include <cstdint>

namespace tp {

/// What a ray can hit; the tag of the union Hittable.
enum class HittableKind : uint8_t { Sphere, Ellipsoid, Rectangle, Box, Disk, Triangle, Mesh };

enum class MaterialKind : uint8_t {
    Lambertian,
    Metal,
    Dielectric,
    DiffuseLight,
    Principled,
    Conductor
};

enum class TextureKind : uint8_t { Constant, Checker, Image, Noise, Marble, Wood, Brick };

/// Where the pattern of a texture lies: it moves with the object, it stays in the world, or it lies
/// on the surface by its texture coordinates.
enum class TextureSpace : uint8_t { Object, World, Uv };

/// What a noise texture makes of gradient noise (kernel/noise.h).
enum class NoisePattern : uint8_t { Gradient, Fbm, Turbulence, Ridged };

enum class Axis : uint8_t { X, Y, Z };

/// How an image is laid on a surface: by texture coordinates, or from three sides at once.
enum class TextureProjection : uint8_t { Uv, Triplanar };

/// Textures inside textures, at most; of those that mix two colours, whose both sides are looked
/// up, fewer.
inline constexpr int kMaxTextureNesting = 64;
inline constexpr int kMaxBlendNesting = 4;

inline constexpr int kMaxOctaves = 16;
inline constexpr int kMinNoiseRounds = 2;  // of the TEA; kMaxTeaRounds at most

/// Which side of a shape a light emits on. Auto: front for flat shapes, outside for closed ones.
/// Front is the side of the normal; Outside the outer side of a closed shape even where its normal
/// points inwards, the front of a flat one.
enum class EmissionSide : uint8_t { Auto, Front, Outside, Both };

enum class FresnelRule : uint8_t { Exact, Schlick };

/// Metals whose index of refraction is known; Custom has its own.
enum class ConductorMetal : uint8_t {
    Custom,
    Gold,
    Silver,
    Copper,
    Aluminium,
    Brass,
    Chromium,
    Tungsten
};

/// Which share of GGX facets both directions see: with heights correlated, or the product of what
/// each sees.
enum class MaskingRule : uint8_t { Correlated, Separable };

/// Checker in texture coordinates (parity of floor(u * cells) + floor(v * cells)) or in world space
/// (sign of sin(s x) sin(s y) sin(s z)).
enum class CheckerMode : uint8_t { Uv, World };

enum class WrapMode : uint8_t { Repeat, Clamp, Mirror };
enum class WrapModeV : uint8_t { AsU, Repeat, Clamp, Mirror };

/// What the alpha of a colour does: it is the opacity, is ignored, or is compared with a threshold.
enum class AlphaMode : uint8_t { Blend, Opaque, Mask };

/// Sets of texture coordinates of a mesh that textures can choose from.
inline constexpr int kUvSets = 2;

/// The channel of a texture that a number is read from.
enum class TextureChannel : uint8_t { Red, Green, Blue, Alpha };

enum class FilterMode : uint8_t { Nearest, Bilinear };

/// What the numbers of an image mean. Auto: sRGB for 8 and 16 bit, linear for float.
enum class ColorSpace : uint8_t { Auto, Srgb, Linear };

enum class BackgroundKind : uint8_t { Gradient, Constant, Image, Sky };

/// What the camera sees of the background itself: what shines on the scene, or something else.
enum class BackdropKind : uint8_t { Same, Constant, Image };

/// Where the sun of a sky stands: at given angles, or where it is seen from a place on the earth.
enum class SunRule : uint8_t { Angles, Place };

/// How a camera maps directions to its film.
enum class ProjectionKind : uint8_t { Perspective, Orthographic, Fisheye, Equirectangular };

/// What the picture's brightness follows: stops alone, an exposure value at ISO 100, or the
/// settings of a photo camera, whose exposure value follows.
enum class ExposureRule : uint8_t { Stops, Ev, Photo };

enum class IntegratorKind : uint8_t {
    Path,    // light sampling, multiple importance sampling, Russian roulette
    Book,    // the plain integrator of Ray Tracing in One Weekend: no light sampling, no roulette
    Normal,  // (n + 1) / 2 of the shading normal, background elsewhere
    Flat     // the material's colour as it is, without light
};

/// How a Lambertian surface scatters in the Book integrator. Cosine is Lambert's law; Hemisphere
/// (uniform) and CosineCubed (normal plus a point in the unit ball) are kept for comparison.
enum class ScatterRule : uint8_t { Cosine, Hemisphere, CosineCubed };

enum class SamplerKind : uint8_t { Tea, Sobol };

/// Which light a surface's direct light is taken from: by a tree of how much each may bring, or
/// each alike, which is kept for comparison.
enum class LightRule : uint8_t { Tree, Uniform };

/// The curve from linear radiance to display value; kernel/tone_curves.h has the sources.
enum class ToneCurve : uint8_t { Srgb, Gamma2, Linear, Aces, Agx, Neutral };

}  // namespace tp
