// AC-N3 on CUDA: noise is the same as on the host but for the last bits, its lattice points
// entirely.
#include "support/backend_option.h"

#include <teapath/device/cuda_buffer.cuh>
#include <teapath/device/cuda_stream.cuh>
#include <teapath/kernel/noise.h>

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace tp::test {
namespace {

constexpr uint32_t kPoints = 1u << 16;

// Everything that noise gives at one place.
struct NoiseValues {
    Noise2 plane;
    Noise3 space, octaves;
    Real turbulent, ridged;
};

// Place i: spread over some hundred cells around the origin; every eighth is a lattice point.
TP_HD Vec3 place(uint32_t i) {
    const TeaBlock a = tea_encrypt({i, 0}, {}, 8), b = tea_encrypt({i, 1}, {}, 8);
    const Vec3 p =
        (Vec3(unit_real(a.v0), unit_real(a.v1), unit_real(b.v0)) - Vec3(Real(0.5))) * Real(200);
    return i % 8 == 0 ? Vec3(std::floor(p.x), std::floor(p.y), std::floor(p.z)) : p;
}

TP_HD NoiseValues noise_values(uint32_t i) {
    const NoiseHash hash = noise_hash(uint64_t{i % 3} << 33, static_cast<int32_t>(4 + i % 5));
    const NoiseOctaves octaves{4, 2, Real(0.5)};
    const Vec3 p = place(i);
    return {gradient_noise(hash, Vec2(p.x, p.y)), gradient_noise(hash, p), fbm(hash, p, octaves),
            turbulence(hash, p, octaves), ridged_noise(hash, p, octaves)};
}

__global__ void noise_kernel(NoiseValues* values) {
    const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < kPoints) values[i] = noise_values(i);
}

double apart(Real a, Real b) {
    return std::abs(static_cast<double>(a) - static_cast<double>(b));
}

}  // namespace

TEST_CASE("AC-N3: noise is the same on host and CUDA, within rounding") {
    if (backend_name() != "cuda") {
        MESSAGE("needs a GPU: run with --backend cuda");
        return;
    }
    const Stream stream;
    DeviceBuffer<NoiseValues> on_device(kPoints);
    noise_kernel<<<kPoints / 128, 128, 0, stream.get()>>>(on_device.data());
    check(cudaGetLastError());
    std::vector<NoiseValues> values(kPoints);
    on_device.download(values.data(), stream.get());
    double plane = 0, space = 0, sums = 0;
    uint32_t not_zero = 0;
    for (uint32_t i = 0; i < kPoints; ++i) {
        const NoiseValues host = noise_values(i);
        const NoiseValues& device = values[i];
        plane = std::fmax(plane, apart(device.plane.value, host.plane.value));
        space = std::fmax(space, apart(device.space.value, host.space.value));
        for (int axis = 0; axis < 3; ++axis)
            space =
                std::fmax(space, apart(device.space.gradient[axis], host.space.gradient[axis]) / 4);
        sums = std::fmax(sums, apart(device.octaves.value, host.octaves.value));
        sums = std::fmax(sums, apart(device.turbulent, host.turbulent));
        sums = std::fmax(sums, apart(device.ridged, host.ridged));
        not_zero += i % 8 == 0 && (device.plane.value != 0 || device.space.value != 0);
    }
    MESSAGE("largest differences: plane " << plane << ", space " << space << ", octaves " << sums);
    CHECK(plane < 2e-6);
    CHECK(space < 2e-6);
    // The places of higher octaves are rounded too: at 1,600 a step of float is 1.2e-4 cells.
    CHECK(sums < 2e-3);
    CHECK(not_zero == 0);
}

}  // namespace tp::test
