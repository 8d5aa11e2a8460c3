// The film, as kernels write it: per pixel, sums over blocks of samples. A block is kBlockSamples
// consecutive samples from a multiple of it; a launch adds to its blocks, then `fold_block` takes
// them in order into the total, with a compensated sum. So the order of additions depends on the
// sample numbers alone, not on how they were split into launches.
#pragma once

#include <teapath/core/span.h>
#include <teapath/kernel/records.h>
#include <teapath/kernel/settings.h>

namespace tp {

inline constexpr int64_t kBlockSamples = 32;

/// False for NaN, infinity and what is beyond kMaxRadiance.
TP_HD bool fits_film(Vec3 c) {
    constexpr Real kMost = Real(kMaxRadiance);
    return abs(c.x) <= kMost && abs(c.y) <= kMost && abs(c.z) <= kMost;
}

/// Sums of one block: radiance in x, y, z and squared luminance in w.
using BlockSum = Real4;

/// A running total with its compensation (Neumaier 1974).
struct Total {
    Real4 sum;
    Real4 compensation;
};

TP_HD void add_compensated(Real& sum, Real& compensation, Real x) {
    const Real t = sum + x;
    // volatile-free on purpose: the files that fold are compiled without unsafe arithmetic.
    compensation += abs(sum) >= abs(x) ? (sum - t) + x : (x - t) + sum;
    sum = t;
}

TP_HD void fold_block(Total& total, const BlockSum& block) {
    add_compensated(total.sum.x, total.compensation.x, block.x);
    add_compensated(total.sum.y, total.compensation.y, block.y);
    add_compensated(total.sum.z, total.compensation.z, block.z);
    add_compensated(total.sum.w, total.compensation.w, block.w);
}

/// Sums over samples of what the camera ray meets first.
struct FeatureSum {
    Vec3 albedo{0, 0, 0};
    Vec3 normal{0, 0, 0};
    Real depth = 0;
    Real hits = 0;
};

/// What was counted while samples were traced.
struct TraceCounts {
    uint32_t rays = 0;     // segments of paths, and queries for light
    uint32_t invalid = 0;  // samples that were not finite
};

/// The film's mean after `samples`: total, its compensation and the block that is not full yet.
TP_HD Vec3 mean_radiance(const Total& total, const BlockSum& open, int64_t samples) {
    const Real scale = samples > 0 ? 1 / static_cast<Real>(samples) : 0;
    return Vec3(total.sum.x + (total.compensation.x + open.x),
                total.sum.y + (total.compensation.y + open.y),
                total.sum.z + (total.compensation.z + open.z)) *
           scale;
}

}  // namespace tp
