#include "cuda_kernels.cuh"
#include "variants.h"

#include <teapath/device/cuda_check.cuh>
#include <teapath/kernel/trace_pixel.h>
#include <teapath/render/kernel_report.h>

#include <cub/block/block_reduce.cuh>

namespace tp {
namespace {

constexpr int kFilmThreads = 256;

// One thread traces one block of samples of one pixel.
template <uint32_t kFeatures>
__global__ void __launch_bounds__(kTraceThreads)
    trace_kernel(const __grid_constant__ LaunchParams params,
                 const __grid_constant__ TraceLaunch launch) {
    uint32_t x, y;
    if (!pixel_of_thread((launch.first_group + blockIdx.x) * kTraceThreads + threadIdx.x,
                         params.width, params.height, x, y))
        return;
    const int64_t block = launch.first_block + blockIdx.y;
    const int64_t block_start = block * kBlockSamples, block_end = block_start + kBlockSamples;
    const int64_t first = launch.first > block_start ? launch.first : block_start;
    const int64_t last = launch.last < block_end ? launch.last : block_end;
    const uint32_t pixel = y * static_cast<uint32_t>(params.width) + x;
    const uint32_t pixels =
        static_cast<uint32_t>(params.width) * static_cast<uint32_t>(params.height);

    BlockSum sum = first > block_start ? launch.open[pixel] : BlockSum{0, 0, 0, 0};
    const TraceCounts counts = trace_pixel<kFeatures>(params, x, y, first, last, sum);
    const size_t slot = static_cast<size_t>(blockIdx.y) * pixels + pixel;
    launch.sums[slot] = sum;
    // Nothing here that the lanes of a warp do together, an addition to one address neither: other
    // lanes are still in the loop, and the compiler (CUDA 13.0) would overwrite uniform registers
    // that they read.
    launch.counts[slot] = counts;
}

template <uint32_t kFeatures>
__global__ void __launch_bounds__(kTraceThreads)
    features_kernel(const __grid_constant__ LaunchParams params, int64_t first, int64_t last,
                    FeatureSum* sums) {
    uint32_t x, y;
    if (!pixel_of_thread(blockIdx.x * kTraceThreads + threadIdx.x, params.width, params.height, x,
                         y))
        return;
    const uint32_t pixel = y * static_cast<uint32_t>(params.width) + x;
    FeatureSum sum = sums[pixel];
    for (int64_t s = first; s < last; ++s) {
        add_features<kFeatures>(params, x, y, static_cast<uint64_t>(s), sum);
        // All lanes go round this loop equally often, so the compiler (CUDA 13.0) keeps what it
        // needs in uniform registers, and lanes that run ahead would overwrite them for the others.
        __syncwarp();
    }
    sums[pixel] = sum;
}

template <uint32_t kFeatures>
__global__ void __launch_bounds__(kTraceThreads)
    hittables_kernel(const __grid_constant__ LaunchParams params, uint32_t* hittables) {
    uint32_t x, y;
    if (!pixel_of_thread(blockIdx.x * kTraceThreads + threadIdx.x, params.width, params.height, x,
                         y))
        return;
    hittables[y * static_cast<uint32_t>(params.width) + x] = hittable_at<kFeatures>(
        params, static_cast<Real>(x) + Real(0.5), static_cast<Real>(y) + Real(0.5));
}

// Adds what a pixel's blocks have counted; all threads of a group call it.
__device__ void add_counts(const TraceLaunch& launch, uint32_t pixel, uint32_t pixels,
                           LaunchCounts& sum) {
    using Reduce = cub::BlockReduce<unsigned long long, kFilmThreads>;
    __shared__ typename Reduce::TempStorage shared;
    unsigned long long rays = 0, invalid = 0;
    for (int32_t b = 0; b < launch.block_count && pixel < pixels; ++b) {
        const TraceCounts counts = launch.counts[static_cast<size_t>(b) * pixels + pixel];
        rays += counts.rays;
        invalid += counts.invalid;
    }
    rays = Reduce(shared).Sum(rays);
    __syncthreads();
    invalid = Reduce(shared).Sum(invalid);
    if (threadIdx.x > 0) return;
    atomicAdd(&sum.rays, rays);
    if (invalid > 0) atomicAdd(&sum.invalid, invalid);
}

__global__ void fold_kernel(const __grid_constant__ TraceLaunch launch, uint32_t pixels,
                            Total* totals, BlockSum* open, LaunchCounts* counts) {
    const uint32_t pixel = blockIdx.x * kFilmThreads + threadIdx.x;
    add_counts(launch, pixel, pixels, *counts);
    if (pixel >= pixels) return;
    Total total = totals[pixel];
    BlockSum rest{0, 0, 0, 0};
    for (int32_t b = 0; b < launch.block_count; ++b) {
        const BlockSum sum = launch.sums[static_cast<size_t>(b) * pixels + pixel];
        const bool is_full = (launch.first_block + b + 1) * kBlockSamples <= launch.last;
        if (is_full)
            fold_block(total, sum);
        else
            rest = sum;
    }
    totals[pixel] = total;
    open[pixel] = rest;
}

__global__ void display_kernel(const Total* totals, const BlockSum* open, uint32_t pixels,
                               int64_t samples, DisplaySettings display, Rgb8* rgb) {
    const uint32_t pixel = blockIdx.x * kFilmThreads + threadIdx.x;
    if (pixel >= pixels) return;
    rgb[pixel] = display_color(mean_radiance(totals[pixel], open[pixel], samples), display);
}

__global__ void mean_kernel(const Total* totals, const BlockSum* open, uint32_t pixels,
                            int64_t samples, Real4* mean) {
    const uint32_t pixel = blockIdx.x * kFilmThreads + threadIdx.x;
    if (pixel >= pixels) return;
    const Vec3 radiance = mean_radiance(totals[pixel], open[pixel], samples);
    mean[pixel] = {radiance.x, radiance.y, radiance.z, 1};
}

unsigned groups(uint32_t threads, int size) {
    return (threads + static_cast<uint32_t>(size) - 1) / static_cast<uint32_t>(size);
}

}  // namespace

void launch_trace(uint32_t features, const LaunchParams& params, const TraceLaunch& launch,
                  cudaStream_t stream) {
    const dim3 grid(launch.group_count, static_cast<unsigned>(launch.block_count));
    with_variant(features, [&]<uint32_t kFeatures>() {
        trace_kernel<kFeatures><<<grid, kTraceThreads, 0, stream>>>(params, launch);
    });
    check(cudaGetLastError());
}

void launch_features(uint32_t features, const LaunchParams& params, int64_t first, int64_t last,
                     FeatureSum* sums, cudaStream_t stream) {
    const unsigned grid = groups_for(params.width, params.height);
    with_variant(features, [&]<uint32_t kFeatures>() {
        features_kernel<kFeatures><<<grid, kTraceThreads, 0, stream>>>(params, first, last, sums);
    });
    check(cudaGetLastError());
}

void launch_hittables(uint32_t features, const LaunchParams& params, uint32_t* hittables,
                      cudaStream_t stream) {
    const unsigned grid = groups_for(params.width, params.height);
    with_variant(features, [&]<uint32_t kFeatures>() {
        hittables_kernel<kFeatures><<<grid, kTraceThreads, 0, stream>>>(params, hittables);
    });
    check(cudaGetLastError());
}

void launch_fold(const TraceLaunch& launch, uint32_t pixels, Total* totals, BlockSum* open,
                 LaunchCounts* counts, cudaStream_t stream) {
    fold_kernel<<<groups(pixels, kFilmThreads), kFilmThreads, 0, stream>>>(launch, pixels, totals,
                                                                           open, counts);
    check(cudaGetLastError());
}

void launch_display(const Total* totals, const BlockSum* open, uint32_t pixels, int64_t samples,
                    const DisplaySettings& display, Rgb8* rgb, cudaStream_t stream) {
    display_kernel<<<groups(pixels, kFilmThreads), kFilmThreads, 0, stream>>>(
        totals, open, pixels, samples, display, rgb);
    check(cudaGetLastError());
}

void launch_mean(const Total* totals, const BlockSum* open, uint32_t pixels, int64_t samples,
                 Real4* mean, cudaStream_t stream) {
    mean_kernel<<<groups(pixels, kFilmThreads), kFilmThreads, 0, stream>>>(totals, open, pixels,
                                                                           samples, mean);
    check(cudaGetLastError());
}

std::vector<KernelReport> kernel_reports() {
    int device = 0, most_threads = 0;
    check(cudaGetDevice(&device));
    check(cudaDeviceGetAttribute(&most_threads, cudaDevAttrMaxThreadsPerMultiProcessor, device));
    std::vector<KernelReport> reports;
    const auto add = [&]<uint32_t kFeatures>(const char* name) {
        cudaFuncAttributes attributes;
        int blocks = 0;
        check(cudaFuncGetAttributes(&attributes, trace_kernel<kFeatures>));
        check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&blocks, trace_kernel<kFeatures>,
                                                            kTraceThreads, 0));
        reports.push_back({name, attributes.numRegs, attributes.localSizeBytes, kTraceThreads,
                           static_cast<double>(blocks) * kTraceThreads / most_threads});
    };
    add.operator()<kVariantSpheres>("spheres, constant colours");
    add.operator()<kVariantLit>("all shapes and lights, constant colours");
    add.operator()<kVariantBooks>("no meshes, no principled surfaces");
    add.operator()<kVariantModels>("no procedural textures, no bump maps");
    add.operator()<kVariantGeneral>("general");
    return reports;
}

}  // namespace tp
