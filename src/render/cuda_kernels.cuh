// The launches of the CUDA backend: each is a __global__ function over the shared steps.
#pragma once

#include <teapath/kernel/features.h>
#include <teapath/kernel/film_view.h>
#include <teapath/kernel/launch_params.h>
#include <teapath/kernel/post.h>

#include <cstdint>

namespace tp {

inline constexpr int kTraceThreads = 128;

/// Sums over launches; see TraceCounts.
struct LaunchCounts {
    unsigned long long rays, invalid;
};

/// One launch of the path tracer: blocks [first_block, first_block + block_count) of the samples
/// [first, last) of the pixels of some groups of threads.
struct TraceLaunch {
    int64_t first = 0;
    int64_t last = 0;
    int64_t first_block = 0;
    int32_t block_count = 0;
    uint32_t first_group = 0;  // of kTraceThreads threads each
    uint32_t group_count = 0;
    BlockSum* sums = nullptr;        // block_count planes
    const BlockSum* open = nullptr;  // what the first block holds already
    TraceCounts* counts = nullptr;   // block_count planes
};

/// The pixel of thread `i`: warps cover 8 x 4 pixels, so that their rays stay together.
TP_HD bool pixel_of_thread(uint32_t i, int32_t width, int32_t height, uint32_t& x, uint32_t& y) {
    const uint32_t tiles_x = (static_cast<uint32_t>(width) + 7) / 8;
    const uint32_t tile = i / 32, lane = i % 32;
    x = tile % tiles_x * 8 + lane % 8;
    y = tile / tiles_x * 4 + lane / 8;
    return x < static_cast<uint32_t>(width) && y < static_cast<uint32_t>(height);
}

/// Groups of kTraceThreads threads that pixel_of_thread needs for the whole picture.
inline uint32_t groups_for(int32_t width, int32_t height) {
    const uint32_t threads =
        static_cast<uint32_t>((width + 7) / 8) * static_cast<uint32_t>((height + 3) / 4) * 32;
    return (threads + kTraceThreads - 1) / kTraceThreads;
}

/// Launches the variant for the scene's features.
void launch_trace(uint32_t features, const LaunchParams& params, const TraceLaunch& launch,
                  cudaStream_t stream);
void launch_features(uint32_t features, const LaunchParams& params, int64_t first, int64_t last,
                     FeatureSum* sums, cudaStream_t stream);
void launch_hittables(uint32_t features, const LaunchParams& params, uint32_t* hittables,
                      cudaStream_t stream);

/// Takes the sums of a launch, block after block, into the totals; an open last block stays open.
/// Adds its counts to `counts`.
void launch_fold(const TraceLaunch& launch, uint32_t pixels, Total* totals, BlockSum* open,
                 LaunchCounts* counts, cudaStream_t stream);

/// RGB bytes of the film.
void launch_display(const Total* totals, const BlockSum* open, uint32_t pixels, int64_t samples,
                    const DisplaySettings& display, Rgb8* rgb, cudaStream_t stream);

/// The film's mean radiance.
void launch_mean(const Total* totals, const BlockSum* open, uint32_t pixels, int64_t samples,
                 Real4* mean, cudaStream_t stream);

}  // namespace tp
