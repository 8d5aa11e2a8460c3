// Owen-scrambled Sobol points in two dimensions, by hashing (Burley, "Practical Hash-based Owen
// Scrambling", JCGT 9(4), 2020). Each pair of dimensions is such a set of its own, shuffled against
// the others; TEA makes the seeds.
#pragma once

#include <teapath/core/tea.h>

namespace tp {

/// A hash whose bit i depends on bits 0 to i alone, as nested scrambling of reversed bits needs
/// (after Laine and Karras, "Stratified Sampling for Stochastic Transparency", 2011; only even
/// multipliers inside the xor keep the property).
TP_HD uint32_t nested_hash(uint32_t x, uint32_t seed) {
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return x;
}

/// Owen's nested uniform scramble: each bit is flipped as the bits above it and the seed say.
TP_HD uint32_t nested_scramble(uint32_t x, uint32_t seed) {
    return reverse_bits(nested_hash(reverse_bits(x), seed));
}

/// The second dimension of Sobol's sequence: rows of Pascal's triangle modulo 2, highest bit first.
TP_HD uint32_t sobol_second(uint32_t index) {
    uint32_t out = 0;
    for (uint32_t column = 0x80000000u; index != 0; index >>= 1, column ^= column >> 1)
        if (index & 1) out ^= column;
    return out;
}

/// Point `index` of the set that `seeds` names: two words with 32 bits each.
TP_HD TeaBlock sobol_point(uint32_t index, const TeaBlock& seeds) {
    const uint32_t shuffled = nested_scramble(index, seeds.v0);
    // Three seeds out of two words.
    const uint32_t seed_x = seeds.v1,
                   seed_y = seeds.v0 * 0x9e3779b1u ^ (seeds.v1 >> 15 | seeds.v1 << 17);
    return {nested_scramble(reverse_bits(shuffled), seed_x),
            nested_scramble(sobol_second(shuffled), seed_y)};
}

}  // namespace tp
