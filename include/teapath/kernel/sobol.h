// Points of the two-dimensional Sobol sequence, Owen-scrambled by hashing (Burley, "Practical
// Hash-based Owen Scrambling", JCGT 9(4), 2020). The points of one seed with the indices of any
// aligned block of 2^k are a (0, k, 2)-net: each box of area 2^-k whose sides are powers of 1/2
// holds one.
#pragma once

#include <teapath/core/host_device.h>

#include <cstdint>

namespace tp {

struct SobolPoint {
    uint32_t x = 0, y = 0;  // fractions of 2^32
};

/// What a sequence is scrambled by: the order of its points and both of their coordinates.
struct SobolSeed {
    uint32_t order = 0, x = 0, y = 0;
};

/// A hash in which a bit depends on the seed and on the bits below it alone: on reversed bits, a
/// nested uniform scramble. Of the form of Laine and Karras ("Stratified Sampling for Stochastic
/// Transparency", 2011) with Vegdahl's steps and constants ("Building a Better LK Hash", 2021).
TP_HD uint32_t scramble_reversed(uint32_t reversed, uint32_t seed) {
    uint32_t x = reversed;
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// The second coordinate of point `index` with its bits reversed: the product of the index and
/// Pascal's triangle modulo 2. By Lucas' theorem the triangle is a tensor power of one of 2 x 2,
/// so that five steps suffice.
TP_HD uint32_t pascal_product(uint32_t index) {
    uint32_t x = index;
    x ^= (x >> 16) & 0x0000ffffu;
    x ^= (x >> 8) & 0x00ff00ffu;
    x ^= (x >> 4) & 0x0f0f0f0fu;
    x ^= (x >> 2) & 0x33333333u;
    return x ^ ((x >> 1) & 0x55555555u);
}

/// Point `index` of the sequence of `seed`.
TP_HD SobolPoint sobol_point(uint32_t index, const SobolSeed& seed) {
    const uint32_t shuffled = reverse_bits(scramble_reversed(reverse_bits(index), seed.order));
    return {reverse_bits(scramble_reversed(shuffled, seed.x)),
            reverse_bits(scramble_reversed(pascal_product(shuffled), seed.y))};
}

}  // namespace tp
