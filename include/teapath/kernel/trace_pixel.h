// Whole paths for one pixel, one after the other: the simplest schedule over the steps.
#pragma once

#include <teapath/kernel/film_view.h>
#include <teapath/kernel/path_steps.h>

namespace tp {

/// Adds samples [first, last) of pixel (x, y) to `block`. A lane that ends a path begins the next
/// at once, so that on a GPU the lanes of a warp stay busy.
template <uint32_t kFeatures>
TP_HD TraceCounts trace_pixel(const LaunchParams& params, uint32_t x, uint32_t y, int64_t first,
                              int64_t last, BlockSum& block) {
    const uint32_t pixel = y * static_cast<uint32_t>(params.width) + x;
    TraceCounts counts;
    int64_t sample = first;
    Sampler sampler = path_sampler(params, pixel, static_cast<uint64_t>(sample));
    PathState path = start_camera_path<kFeatures>(params, sampler, x, y);
    while (sample < last) {
        const Hit hit = intersect<kFeatures>(params, path);
        ShadowQuery shadow;
        const bool goes_on = shade<kFeatures>(params, sampler, hit, path, shadow);
        ++counts.rays;
        if constexpr ((kFeatures & kFeatureLights) != 0) {
            connect_to_light<kFeatures>(params, shadow, path);
            counts.rays += shadow.is_active;
        }
        if (goes_on) continue;

        bool is_valid;
        const Vec3 radiance = finish_path(path, is_valid);
        counts.invalid += !is_valid;
        block.x += radiance.x;
        block.y += radiance.y;
        block.z += radiance.z;
        block.w += sqr(luminance(radiance));
        if (++sample < last) {
            sampler = path_sampler(params, pixel, static_cast<uint64_t>(sample));
            path = start_camera_path<kFeatures>(params, sampler, x, y);
        }
    }
    return counts;
}

}  // namespace tp
