// Random numbers of one sample of one pixel: pure functions of the dimension, nothing is stored.
#pragma once

#include <teapath/core/tea.h>
#include <teapath/kernel/kinds.h>
#include <teapath/kernel/sobol.h>

namespace tp {

struct Sampler {
    TeaKey key;
    uint32_t pixel = 0;   // y * width + x
    uint32_t sample = 0;  // modulo 2^32; what is above is in the key, for TEA what is above 2^20
    int32_t rounds = 8;
    SamplerKind kind = SamplerKind::Tea;
};

inline constexpr uint32_t kSampleBits = 20, kPairBits = 12;

/// The numbers of sample `sample` of `pixel`.
TP_HD Sampler make_sampler(const TeaKey& key, uint32_t pixel, uint64_t sample, SamplerKind kind,
                           int rounds) {
    Sampler s{key, pixel, static_cast<uint32_t>(sample), rounds, kind};
    const uint64_t above = sample >> (kind == SamplerKind::Sobol ? 32 : kSampleBits);
    if (above) s.key = derive_key({static_cast<uint32_t>(above), 2}, key, 16);
    return s;
}

/// Two words for the pair of dimensions that starts at the even `dimension`.
TP_HD TeaBlock tea_block(const Sampler& s, uint32_t dimension) {
    const uint32_t pair = dimension / 2;
    const TeaBlock block{s.pixel, s.sample << kPairBits | (pair & ((1u << kPairBits) - 1))};
    if (pair >> kPairBits == 0) return tea_encrypt(block, s.key, s.rounds);
    return tea_encrypt(block, derive_key({pair >> kPairBits, 3}, s.key, 16), s.rounds);
}

/// The same from a sequence of points that the pixel and the pair choose, and the sample goes
/// along.
TP_HD TeaBlock sobol_block(const Sampler& s, uint32_t dimension) {
    const uint32_t pair = dimension / 2;
    const TeaBlock a = tea_encrypt({s.pixel, 2 * pair}, s.key, s.rounds);
    const TeaBlock b = tea_encrypt({s.pixel, 2 * pair + 1}, s.key, s.rounds);
    const SobolPoint point = sobol_point(s.sample, {a.v0, a.v1, b.v0});
    return {point.x, point.y};
}

/// A kernel without Sobol points has no code for them.
template <bool kSobol>
TP_HD TeaBlock sample_block(const Sampler& s, uint32_t dimension) {
    if constexpr (kSobol) {
        if (s.kind == SamplerKind::Sobol) return sobol_block(s, dimension);
    }
    return tea_block(s, dimension);
}

/// Two numbers in [0, 1) for dimensions `dimension` (even) and the next.
template <bool kSobol>
TP_HD Vec2 sample_2d(const Sampler& s, uint32_t dimension) {
    const TeaBlock block = sample_block<kSobol>(s, dimension);
    return {unit_real(block.v0), unit_real(block.v1)};
}

template <bool kSobol>
TP_HD Real sample_1d(const Sampler& s, uint32_t dimension) {
    const TeaBlock block = sample_block<kSobol>(s, dimension & ~1u);
    return unit_real(dimension & 1 ? block.v1 : block.v0);
}

}  // namespace tp
