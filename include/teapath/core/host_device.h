// The words that let one source compile for the host and for CUDA, and the few operations whose
// best form differs between them. The only file that looks at compiler macros of CUDA.
#pragma once

#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>

#if defined(__CUDACC__)
#define TP_HD __host__ __device__ inline __attribute__((always_inline))
#define TP_HD_NOINLINE __host__ __device__ __attribute__((noinline)) inline
#define TP_HD_MEMBER __host__ __device__
#else
#define TP_HD inline
#define TP_HD_NOINLINE inline
#define TP_HD_MEMBER
#endif

#define TP_ASSERT(condition) assert(condition)

namespace tp {

#if defined(__CUDA_ARCH__)
inline constexpr bool kOnDevice = true;
#else
inline constexpr bool kOnDevice = false;
#endif

/// The 32 bits of a float, and back.
TP_HD uint32_t float_to_bits(float x) {
#if defined(__CUDA_ARCH__)
    return __float_as_uint(x);
#else
    return std::bit_cast<uint32_t>(x);
#endif
}
TP_HD float bits_to_float(uint32_t bits) {
#if defined(__CUDA_ARCH__)
    return __uint_as_float(bits);
#else
    return std::bit_cast<float>(bits);
#endif
}

/// The smaller and the larger of two numbers. The host returns b where either is NaN (one SSE
/// instruction), the device the one that is a number.
TP_HD float minimum(float a, float b) {
#if defined(__CUDA_ARCH__)
    return fminf(a, b);
#else
    return a < b ? a : b;
#endif
}
TP_HD float maximum(float a, float b) {
#if defined(__CUDA_ARCH__)
    return fmaxf(a, b);
#else
    return a > b ? a : b;
#endif
}

/// a * b, rounded by itself: never fused with a sum that follows.
TP_HD float multiply_exactly_rounded(float a, float b) {
#if defined(__CUDA_ARCH__)
    return __fmul_rn(a, b);
#else
    return a * b;  // the host is compiled with -ffp-contract=off
#endif
}
TP_HD double multiply_exactly_rounded(double a, double b) {
#if defined(__CUDA_ARCH__)
    return __dmul_rn(a, b);
#else
    return a * b;
#endif
}

/// 1 / sqrt(x) for x > 0; on the device the hardware's approximation (2 ulp).
TP_HD float rsqrt(float x) {
#if defined(__CUDA_ARCH__)
    return ::rsqrtf(x);
#else
    return 1.0f / std::sqrt(x);
#endif
}
TP_HD double rsqrt(double x) {
    return 1.0 / sqrt(x);
}

/// sin(2 pi u) and cos(2 pi u) for u in [0, 1]: absolute error below 1e-6 in float.
TP_HD void sincos_2pi(float u, float& sine, float& cosine) {
    const float angle = 6.28318530717958648f * (u < 0.5f ? u : u - 1.0f);
#if defined(__CUDA_ARCH__)
    __sincosf(angle, &sine, &cosine);
#else
    sine = std::sin(angle);
    cosine = std::cos(angle);
#endif
}
TP_HD void sincos_2pi(double u, double& sine, double& cosine) {
    sine = sin(6.283185307179586477 * u);
    cosine = cos(6.283185307179586477 * u);
}

/// Number of leading zero bits, 32 for 0.
TP_HD int count_leading_zeros(uint32_t x) {
#if defined(__CUDA_ARCH__)
    return __clz(static_cast<int>(x));
#else
    return std::countl_zero(x);
#endif
}

/// The 32 bits in reversed order.
TP_HD uint32_t reverse_bits(uint32_t x) {
#if defined(__CUDA_ARCH__)
    return __brev(x);
#else
    x = (x >> 16) | (x << 16);
    x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
    x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
    return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
#endif
}

/// The high 32 bits of a 32 x 32 bit product.
TP_HD uint32_t multiply_high(uint32_t a, uint32_t b) {
#if defined(__CUDA_ARCH__)
    return __umulhi(a, b);
#else
    return static_cast<uint32_t>((static_cast<uint64_t>(a) * b) >> 32);
#endif
}

}  // namespace tp
