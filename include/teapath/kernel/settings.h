// Settings that the kernels read; the scene file, the command line and the panels write them.
#pragma once

#include <teapath/kernel/kinds.h>

#include <cstdint>

namespace tp {

inline constexpr int kMaxPathDepth = 4096;

/// The most radiance that a light, or a sample of the film, may have: sums of its square over 2^30
/// samples stay finite.
inline constexpr double kMaxRadiance = 1e14;

struct PathSettings {
    IntegratorKind integrator = IntegratorKind::Path;
    int32_t max_depth = 50;      // path segments, 1 to 4096; 1 = emission seen by the camera only
    int32_t roulette_depth = 5;  // segments before Russian roulette starts; 0 = never
    bool light_sampling = true;  // next-event estimation with multiple importance sampling
    LightRule light_rule = LightRule::Tree;
    float clamp_direct = 0;      // most radiance of light that was scattered once; 0 = any
    float clamp_indirect = 0;    // of light that was scattered more often; 0 = any
    bool terminator_fix = true;  // lifts rays that leave smooth meshes off their flat triangles
    ScatterRule scatter = ScatterRule::Cosine;  // Book integrator only
    SamplerKind sampler = SamplerKind::Tea;
    int32_t tea_rounds = 8;   // of the path's random numbers, 6 to 32
    int32_t key_rounds = 16;  // of the key derivation, 6 to 32
    uint64_t seed = 0;        // one image for each seed; the low 32 bits key TEA first

    friend bool operator==(const PathSettings&, const PathSettings&) = default;
};

struct DisplaySettings {
    float exposure = 0;  // stops; radiance is multiplied by 2^exposure, after the rule
    ExposureRule rule = ExposureRule::Stops;
    float ev = 10;               // Ev: exposure value at ISO 100
    float f_number = 8;          // Photo
    float shutter = 0.0078125f;  // Photo: seconds
    float iso = 100;             // Photo
    ToneCurve curve = ToneCurve::Srgb;

    friend bool operator==(const DisplaySettings&, const DisplaySettings&) = default;
};

}  // namespace tp
