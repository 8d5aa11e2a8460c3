// The records of the flat arrays, as the kernels read them: PODs with indices instead of pointers.
#pragma once

#include <teapath/core/bounds.h>
#include <teapath/core/span.h>
#include <teapath/kernel/bvh_node.h>
#include <teapath/kernel/hittable.h>
#include <teapath/kernel/kinds.h>
#include <teapath/kernel/scene_features.h>

namespace tp {

/// A constant colour, or the texture that stands in its place.
struct ColorRef {
    Vec3 color{0, 0, 0};
    int32_t texture = -1;  // index of the TextureRecord, -1 = none
};

/// A number, times a channel of the texture if there is one.
struct NumberRef {
    Real value = 0;
    int32_t texture = -1;
    int32_t channel = 0;
};

struct MaterialRecord {
    MaterialKind kind = MaterialKind::Lambertian;
    FresnelRule fresnel = FresnelRule::Exact;
    EmissionSide side = EmissionSide::Outside;  // never Auto, which means Outside
    uint8_t emits = 0;
    ColorRef color;
    ColorRef emission;  // radiance; strength is in the constant, and beside it for textures
    Real strength = 1;
    union {
        Real fuzz;            // Metal
        Real eta;             // Dielectric: index behind the normal over the index before it
        uint32_t principled;  // Principled: index of the PrincipledRecord
    };
    AlphaMode alpha = AlphaMode::Blend;
    Real alpha_cutoff = Real(0.5);
    Real opacity = 1;
    Vec3 pass_through{1, 1, 1};
    NumberRef roughness;                // Dielectric, Conductor
    bool correlated = true;             // masking of rough ones
    bool compensation = true;           // of what rough ones lose
    Vec3 eta_rgb{1, 1, 1}, k{0, 0, 0};  // Conductor: index of refraction

    TP_HD_MEMBER MaterialRecord() : fuzz(0) {}
};

/// The parameters of a principled surface beyond its colour, which the MaterialRecord has.
struct PrincipledRecord {
    NumberRef metallic, roughness, specular, anisotropy;
    ColorRef specular_color;
    Real anisotropy_cosine = 1, anisotropy_sine = 0;  // of its direction from the tangent
    Real ior = Real(1.5);
    NumberRef transmission, diffuse_transmission;
    ColorRef diffuse_transmission_color;
    Vec3 absorption{0, 0, 0};  // within, per scene unit
    NumberRef coat, coat_roughness;
    ColorRef sheen_color;
    NumberRef sheen_roughness;
    int32_t normal = -1;  // index of the TextureRecord of a normal map
    Real normal_scale = 1;
    bool thin = true;
    bool compensation = true;
};

struct CheckerRecord {
    ColorRef even, odd;
    CheckerMode mode;
    Vec2 cells;      // Uv
    Real frequency;  // World: radians per scene unit
};

struct ImageRecord {
    uint64_t offset;  // of the first texel in SceneView::texels, bytes
    int32_t width, height;
    int16_t channels;
    uint8_t bytes_per_channel;  // 1, 2 or 4 (float)
    bool is_srgb;
    uint8_t uv_set;  // 0 or 1
    WrapMode wrap_u, wrap_v;
    FilterMode filter;
    Vec3 u, v;  // (u, v, 1) of the surface times these are u and v of the image
    Vec3 tint;
};

struct TextureRecord {
    TextureKind kind;
    union {
        Vec3 constant;
        CheckerRecord checker;
        ImageRecord image;
    };
    TP_HD_MEMBER TextureRecord() : kind(TextureKind::Constant), constant(0, 0, 0) {}
};

/// An emitting hittable, a triangle of one, or the environment, in an alias table (Walker 1977;
/// Vose 1991) by power.
struct LightRecord {
    uint32_t hittable;     // or kEnvironmentLight
    uint32_t primitive;    // of a mesh, else 0
    Real probability;      // that this light is picked
    Real alias_threshold;  // of the table's column: below it this light, else `alias`
    uint32_t alias;
};

/// The environment among the LightRecords, in place of a hittable.
inline constexpr uint32_t kEnvironmentLight = 0xffffffff;

/// A row or a cell of the environment's grid in an alias table.
struct EnvironmentCell {
    Real probability;
    Real alias_threshold;
    uint32_t alias;
};

/// The grid that the environment image is sampled by (environment.h).
struct EnvironmentView {
    Span<const EnvironmentCell> rows, cells;
    uint32_t width = 0, height = 0;
};

struct BackgroundRecord {
    BackgroundKind kind = BackgroundKind::Constant;
    Vec3 bottom{0, 0, 0}, top{0, 0, 0};  // Gradient; Constant has its colour in `bottom`
    int32_t texture = -1;                // Image; -1 = a missing one
    Real cos_rotation = 1, sin_rotation = 0;
    Real strength = 1;
    Real light_probability = 0;  // that light sampling picks it; 0: never
};

struct CameraRecord {
    Vec3 origin{0, 0, 0};
    Vec3 forward{0, 0, -1};  // unit
    Vec3 right{1, 0, 0};     // unit
    Vec3 up{0, 1, 0};        // unit
    Real half_width = 1;     // of the film at distance 1 along `forward`
    Real half_height = 1;
    Real lens_radius = 0;
    Real focus_distance = 1;
    Real near_clip = 0;  // along `forward`; 0 = off
    Real far_clip = kInfinity;
};

}  // namespace tp
