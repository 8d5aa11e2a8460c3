// Random numbers of one sample of one pixel: pure functions of the dimension, nothing is stored.
#pragma once

#include <teapath/core/tea.h>
#include <teapath/kernel/kinds.h>
#include <teapath/kernel/sobol.h>

namespace tp {

struct Sampler {
    TeaKey key;
    uint32_t pixel = 0;   // y * width + x
    uint32_t sample = 0;  // modulo 2^20; what is above is in the key
    int32_t rounds = 8;
    SamplerKind kind = SamplerKind::Tea;
};

inline constexpr uint32_t kSampleBits = 20, kPairBits = 12;

/// The numbers of sample `sample` of `pixel`.
TP_HD Sampler make_sampler(const TeaKey& key, uint32_t pixel, uint64_t sample, SamplerKind kind,
                           int rounds) {
    Sampler s{key, pixel, static_cast<uint32_t>(sample) & ((1u << kSampleBits) - 1), rounds, kind};
    if (sample >> kSampleBits)
        s.key = derive_key({static_cast<uint32_t>(sample >> kSampleBits), 2}, key, 16);
    return s;
}

/// Two words for the pair of dimensions that starts at the even `dimension`.
TP_HD TeaBlock sample_block(const Sampler& s, uint32_t dimension) {
    const uint32_t pair = dimension / 2;
    const TeaBlock block{s.pixel, s.sample << kPairBits | (pair & ((1u << kPairBits) - 1))};
    if (pair >> kPairBits == 0) return tea_encrypt(block, s.key, s.rounds);
    return tea_encrypt(block, derive_key({pair >> kPairBits, 3}, s.key, 16), s.rounds);
}

/// The pair of words of Owen-scrambled Sobol: the sample's number is the index, pixel and pair of
/// dimensions make the seeds.
TP_HD TeaBlock sobol_block(const Sampler& s, uint32_t dimension) {
    Sampler seeds = s;
    seeds.sample = 0;
    return sobol_point(s.sample, sample_block(seeds, dimension));
}

/// Two numbers in [0, 1) for dimensions `dimension` (even) and the next. With kSobol the sampler's
/// kind decides; without it is TEA.
template <bool kSobol>
TP_HD Vec2 sample_2d(const Sampler& s, uint32_t dimension) {
    TeaBlock block;
    if (kSobol && s.kind == SamplerKind::Sobol)
        block = sobol_block(s, dimension);
    else
        block = sample_block(s, dimension);
    return {unit_real(block.v0), unit_real(block.v1)};
}

/// One number in [0, 1) for dimension `dimension`.
template <bool kSobol>
TP_HD Real sample_1d(const Sampler& s, uint32_t dimension) {
    const Vec2 pair = sample_2d<kSobol>(s, dimension & ~1u);
    return dimension & 1 ? pair.y : pair.x;
}

}  // namespace tp
