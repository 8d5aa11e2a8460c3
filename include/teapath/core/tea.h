// The Tiny Encryption Algorithm as a counter-based random number generator (Wheeler and Needham
// 1994; Zafar, Olano, Curtis, "GPU Random Numbers via the Tiny Encryption Algorithm", HPG 2010).
// One round here is one cycle of the algorithm, that is two Feistel rounds.
#pragma once

#include <teapath/core/math.h>

#include <cstdint>
#include <utility>

namespace tp {

struct TeaKey {
    uint32_t k0 = 0, k1 = 0, k2 = 0, k3 = 0;
    friend bool operator==(const TeaKey&, const TeaKey&) = default;
};

struct TeaBlock {
    uint32_t v0 = 0, v1 = 0;
    friend bool operator==(const TeaBlock&, const TeaBlock&) = default;
};

inline constexpr uint32_t kTeaDelta = 0x9e3779b9u;

/// The initial key of key derivations.
TP_HD constexpr TeaKey tea_initial_key() {
    return {0xa341316cu, 0xc8013ea4u, 0xad90777du, 0x7e95761eu};
}

inline constexpr int kMinTeaRounds = 6;  // for paths and keys
inline constexpr int kMaxTeaRounds = 32;

TP_HD void tea_cycle(TeaBlock& b, const TeaKey& key, uint32_t sum) {
    b.v0 += ((b.v1 << 4) + key.k0) ^ (b.v1 + sum) ^ ((b.v1 >> 5) + key.k1);
    b.v1 += ((b.v0 << 4) + key.k2) ^ (b.v0 + sum) ^ ((b.v0 >> 5) + key.k3);
}

template <uint32_t... kIndex>
TP_HD void tea_cycles(TeaBlock& block, const TeaKey& key,
                      std::integer_sequence<uint32_t, kIndex...>) {
    (tea_cycle(block, key, (kIndex + 1) * kTeaDelta), ...);
}

/// Encrypts with a number of rounds known at compile time: straight-line code.
template <int kRounds>
TP_HD TeaBlock tea_encrypt(TeaBlock block, const TeaKey& key) {
    tea_cycles(block, key, std::make_integer_sequence<uint32_t, kRounds>{});
    return block;
}

/// Encrypts with `rounds` >= 0 rounds.
TP_HD TeaBlock tea_encrypt(TeaBlock block, const TeaKey& key, int rounds) {
    if (rounds == 8) return tea_encrypt<8>(block, key);
    if (rounds == 6) return tea_encrypt<6>(block, key);
    uint32_t sum = 0;
    for (int i = 0; i < rounds; ++i) {
        sum += kTeaDelta;
        tea_cycle(block, key, sum);
    }
    return block;
}

/// The inverse of tea_encrypt.
TP_HD TeaBlock tea_decrypt(TeaBlock b, const TeaKey& key, int rounds) {
    uint32_t sum = static_cast<uint32_t>(rounds) * kTeaDelta;
    for (int i = 0; i < rounds; ++i) {
        b.v1 -= ((b.v0 << 4) + key.k2) ^ (b.v0 + sum) ^ ((b.v0 >> 5) + key.k3);
        b.v0 -= ((b.v1 << 4) + key.k0) ^ (b.v1 + sum) ^ ((b.v1 >> 5) + key.k1);
        sum -= kTeaDelta;
    }
    return b;
}

/// A key from two words of data and an initial key by two passes (Sebald, "OptiX-based Raytracing
/// with Volumetric Effects", 2011, Fig. 4).
TP_HD TeaKey derive_key(TeaBlock data, const TeaKey& initial, int rounds) {
    const TeaBlock a = tea_encrypt(data, initial, rounds);
    const TeaBlock b = tea_encrypt(data, {initial.k1, a.v0, initial.k3, a.v1}, rounds);
    return {b.v0, a.v0, b.v1, a.v1};
}

/// The key of a device's stream: from (device, low half of the seed); a high half that is not zero
/// goes in by one more pass. Rounds are clamped to [6, 32].
TP_HD TeaKey tea_key(uint32_t device, uint64_t seed, int rounds = 16) {
    rounds = rounds < kMinTeaRounds   ? kMinTeaRounds
             : rounds > kMaxTeaRounds ? kMaxTeaRounds
                                      : rounds;
    const TeaKey key = derive_key({device, static_cast<uint32_t>(seed)}, tea_initial_key(), rounds);
    const auto high = static_cast<uint32_t>(seed >> 32);
    return high == 0 ? key : derive_key({high, 1}, key, rounds);
}

/// The representative of the four keys that encrypt alike: flipping the top bits of k0 and k1, or
/// of k2 and k3, changes nothing (Kelsey, Schneier, Wagner 1996).
TP_HD TeaKey canonical(TeaKey key) {
    const uint32_t top = 0x80000000u;
    if (key.k0 & top) key.k0 ^= top, key.k1 ^= top;
    if (key.k2 & top) key.k2 ^= top, key.k3 ^= top;
    return key;
}

/// The generator of the OptiX SDK's samples, for comparison with programs that use it: a linear
/// congruential generator of which 24 bits are taken.
struct OptixRandom {
    uint32_t state = 0;
    TP_HD_MEMBER uint32_t next_bits() {
        state = 1664525u * state + 1013904223u;
        return state & 0x00ffffffu;
    }
    /// A number in [0, 1).
    TP_HD_MEMBER float next() { return static_cast<float>(next_bits()) * 0x1p-24f; }
};

/// Seeds it as they do, by word 0 of `kRounds` rounds of TEA.
template <int kRounds>
TP_HD OptixRandom optix_random(uint32_t a, uint32_t b) {
    return {tea_encrypt<kRounds>({a, b}, tea_initial_key()).v0};
}

/// A number in [0, 1), never 1: 24 bits as float, 32 as double.
TP_HD Real unit_real(uint32_t bits) {
    if constexpr (sizeof(Real) == 4) return static_cast<Real>(bits >> 8) * Real(0x1p-24);
    return static_cast<Real>(bits) * Real(0x1p-32);
}

}  // namespace tp
