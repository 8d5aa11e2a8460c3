// The records of the flat arrays, as the kernels read them: PODs with indices instead of pointers.
#pragma once

#include <teapath/core/bounds.h>
#include <teapath/core/span.h>
#include <teapath/kernel/bvh_node.h>
#include <teapath/kernel/hittable.h>
#include <teapath/kernel/kinds.h>

namespace tp {

/// A constant colour, or the texture that stands in its place.
struct ColorRef {
    Vec3 color{0, 0, 0};
    int32_t texture = -1;  // index of the TextureRecord, -1 = none
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
        Real fuzz;  // Metal
        Real eta;   // Dielectric: index behind the normal over the index before it
    };
    AlphaMode alpha = AlphaMode::Blend;
    Real alpha_cutoff = Real(0.5);
    Real opacity = 1;
    Vec3 pass_through{1, 1, 1};

    TP_HD_MEMBER MaterialRecord() : fuzz(0) {}
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

/// An emitting hittable, or a triangle of one, in an alias table (Walker 1977; Vose 1991) by power.
struct LightRecord {
    uint32_t hittable;
    uint32_t primitive;    // of a mesh, else 0
    Real probability;      // that this light is picked
    Real alias_threshold;  // of the table's column: below it this light, else `alias`
    uint32_t alias;
};

struct BackgroundRecord {
    BackgroundKind kind = BackgroundKind::Constant;
    Vec3 bottom{0, 0, 0}, top{0, 0, 0};  // Gradient; Constant has its colour in `bottom`
    int32_t texture = -1;                // Image; -1 = a missing one
    Real cos_rotation = 1, sin_rotation = 0;
    Real strength = 1;
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

/// What a scene contains, as bits: a kernel is compiled for some sets of them.
enum SceneFeature : uint32_t {
    kFeatureShapes = 1,    // hittables that are not spheres
    kFeatureTextures = 2,  // any texture, an image as background
    kFeatureLights = 4,    // emitting hittables
    kFeatureOpacity = 8,   // materials that let light straight through
    kFeatureSobol = 16,    // the Sobol sampler
    kFeatureDebug = 32,    // integrators other than Path and Book; brute force
    kFeatureMeshes = 64,   // hittables that are meshes
    kFeatureAll = 127
};

}  // namespace tp
