// The records of the flat arrays, as the kernels read them: PODs with indices instead of pointers.
#pragma once

#include <teapath/core/bounds.h>
#include <teapath/core/span.h>
#include <teapath/core/tea.h>
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
    Real cone_cosine = 0, cone_gain = 0;  // of emission; gain 0: the whole half space
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
    Real ior_spread = 0;  // of blue over green and of green over red
    NumberRef transmission, diffuse_transmission;
    ColorRef diffuse_transmission_color;
    Vec3 absorption{0, 0, 0};  // within, per scene unit
    NumberRef coat, coat_roughness;
    int32_t coat_normal = -1;  // as `normal`
    Real coat_normal_scale = 1;
    NumberRef iridescence, film_thickness;  // the latter is a share of what follows
    Real film_ior = Real(1.3);
    Real film_low = 0, film_high = 0;  // nanometres
    ColorRef sheen_color;
    NumberRef sheen_roughness;
    int32_t normal = -1;  // index of the TextureRecord of a normal map
    Real normal_scale = 1;
    int32_t bump = -1;    // index of the TextureRecord of a height
    Real bump_scale = 0;  // scene units where it is 1
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
    TextureProjection projection;
    TextureSpace space;  // Triplanar: of its plane coordinates, which stand for uv
    Real sharpness;      // Triplanar: power of the normal's parts
};

/// Two colours, or the textures in their place, that a pattern mixes (procedural.h).
struct PatternRecord {
    ColorRef first, second;
    TeaKey key;  // of its noise
    uint8_t rounds, octaves;
    NoisePattern pattern;  // Noise
    TextureSpace space;
    Axis axis;    // Marble: across the layers; Wood: along the trunk
    Real detail;  // finest features in a unit of its space
    Vec3 scale;   // cells in a unit of its space; Brick: its width and height, the joint's
    Real lacunarity, gain;
    Real contrast;    // Noise; Marble: power of the veins; Wood: grain; Brick: variation
    Real distortion;  // Marble, Wood; Brick: shift from row to row, in bricks
    Real edge;        // Brick: share of the joint's width that merges with the brick
};

struct TextureRecord {
    TextureKind kind;
    union {
        Vec3 constant;
        CheckerRecord checker;
        ImageRecord image;
        PatternRecord pattern;  // Noise, Marble, Wood, Brick
    };
    TP_HD_MEMBER TextureRecord() : kind(TextureKind::Constant), constant(0, 0, 0) {}
};

/// A hittable whose object has a transform, but for meshes, which have theirs in the instance.
struct PlacementRecord {
    uint32_t hittable;
    Affine object_from_world;
};

/// An emitting hittable, or a triangle of one.
struct LightRecord {
    uint32_t hittable;
    uint32_t primitive;  // of a mesh, else 0
    uint32_t trail;      // the way from the tree's root, the first turn lowest: 1 = second child
};

/// A node of the tree of lights (light_tree.h). Its first child follows it.
struct LightNode {
    Vec3 low, high;   // box of the lights
    Vec3 axis;        // unit; the cone around it that holds their normals
    Real cos_spread;  // of its half angle; -1: all directions
    Real cos_reach;   // of the angle from a normal within which light is sent
    Real power;       // luminance times area, up to a common factor
    uint32_t next;    // the second child; of a leaf the light
    uint8_t is_leaf;
    uint8_t two_sided;  // some of them emit on both sides
};

/// The depth of that tree at most: the bits of LightRecord::trail.
inline constexpr uint32_t kMaxLightTreeDepth = 32;

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
    Vec3 scale{1, 1, 1};         // strength and tint
    Real light_probability = 0;  // that light sampling picks it, not a light; 0: never

    Vec3 sun_direction{0, 1, 0};  // unit
    Vec3 sun_radiance{0, 0, 0};   // added to what is behind
    Real sun_chord2 = 0;          // of its radius: squared distance of unit directions; 0 = no sun
    Real sun_probability = 0;     // that sampling the background picks the sun

    BackdropKind backdrop = BackdropKind::Same;
    Vec3 backdrop_color{0, 0, 0};
    int32_t backdrop_texture = -1;
};

struct CameraRecord {
    ProjectionKind projection = ProjectionKind::Perspective;
    Vec3 origin{0, 0, 0};
    Vec3 forward{0, 0, -1};  // unit
    Vec3 right{1, 0, 0};     // unit
    Vec3 up{0, 1, 0};        // unit
    // Half of the film: Perspective at distance 1 along `forward`, Orthographic in scene units,
    // Fisheye in radians.
    Real half_width = 1;
    Real half_height = 1;
    Vec2 shift{0, 0};  // of the film, in halves of it
    Real lens_radius = 0;
    int32_t blades = 0;                     // of the aperture; below 3 it is round
    Real blade_cosine = 1, blade_sine = 0;  // of its rotation
    Real focus_distance = 1;
    Real near_clip = 0;  // along `forward`; 0 = off
    Real far_clip = kInfinity;
};

}  // namespace tp
