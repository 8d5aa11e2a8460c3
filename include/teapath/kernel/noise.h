// Gradient noise (Perlin, "An Image Synthesizer", 1985) on the Tiny Encryption Algorithm instead of
// tables, with the fade of his "Improving Noise" (2002): unit gradients at the points of a lattice,
// hashed by Zafar, Olano and Curtis, "GPU Random Numbers via the Tiny Encryption Algorithm", 2010.
// Zero at each lattice point, mean 0; two continuous derivatives.
#pragma once

#include <teapath/core/tea.h>

namespace tp {

/// What turns lattice points into gradients.
struct NoiseHash {
    TeaKey key;
    int32_t rounds = 6;  // of the TEA
    int32_t word = 0;    // of its block that is taken
};

/// The hash of a seed. Below 6 rounds neighbours are alike in word 0 of a block, far less so in
/// word 1, which is taken there; 2 rounds are hardly noise.
TP_HD NoiseHash noise_hash(const TeaKey& key, int rounds) {
    return {key, rounds, rounds < 6 ? 1 : 0};
}
TP_HD NoiseHash noise_hash(uint64_t seed, int rounds = 6) {
    return noise_hash(tea_key(0, seed), rounds);
}

/// A value and its derivatives.
struct Noise2 {
    Real value;
    Vec2 gradient;
};
struct Noise3 {
    Real value;
    Vec3 gradient;
};

/// 6 t^5 - 15 t^4 + 10 t^3 and its derivative.
TP_HD Real fade(Real t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}
TP_HD Real fade_slope(Real t) {
    return 30 * t * t * (t * (t - 2) + 1);
}

/// A lattice coordinate as bits: beyond 2^30 the lattice ends.
TP_HD uint32_t lattice_bits(Real cell) {
    return static_cast<uint32_t>(
        static_cast<int32_t>(clamp(cell, Real(-1073741824), Real(1073741824))));
}

TP_HD uint32_t lattice_hash(const NoiseHash& hash, uint32_t v0, uint32_t v1) {
    const TeaBlock block = tea_encrypt({v0, v1}, hash.key, hash.rounds);
    return hash.word == 0 ? block.v0 : block.v1;
}

/// The hash of a lattice point in space. A block has room for 21 bits of x, 21 of y and 22 of z,
/// so that the lattice repeats after two million cells.
TP_HD uint32_t lattice_hash(const NoiseHash& hash, uint32_t x, uint32_t y, uint32_t z) {
    return lattice_hash(hash, (x & 0x1fffff) | (z << 21), (y & 0x1fffff) | (z >> 11 << 21));
}

/// A unit vector, uniform over the circle.
TP_HD Vec2 lattice_gradient2(uint32_t bits) {
    Real sine = 0, cosine = 0;
    sincos_2pi(unit_real(bits), sine, cosine);
    return {cosine, sine};
}

/// A unit vector, uniform over the sphere.
TP_HD Vec3 lattice_gradient3(uint32_t bits) {
    const Real z = (static_cast<Real>(bits >> 16) + Real(0.5)) * Real(0x1p-15) - 1;
    Real sine = 0, cosine = 0;
    sincos_2pi(static_cast<Real>(bits & 0xffff) * Real(0x1p-16), sine, cosine);
    const Real radius = tp::sqrt(1 - z * z);
    return {radius * cosine, radius * sine, z};
}

/// Noise of the plane, one cell a unit; within sqrt(1/2) of 0, rms about 0.21.
TP_HD Noise2 gradient_noise(const NoiseHash& hash, Vec2 p) {
    const Vec2 cell{std::floor(p.x), std::floor(p.y)};
    const Vec2 f = p - cell;
    const Vec2 w{fade(f.x), fade(f.y)}, slope{fade_slope(f.x), fade_slope(f.y)};
    const uint32_t x = lattice_bits(cell.x), y = lattice_bits(cell.y);
    Noise2 n{0, {0, 0}};
    for (uint32_t corner = 0; corner < 4; ++corner) {
        const uint32_t i = corner & 1, j = corner >> 1;
        const Vec2 g = lattice_gradient2(lattice_hash(hash, x + i, y + j));
        const Real along = dot(g, f - Vec2(static_cast<Real>(i), static_cast<Real>(j)));
        const Real wx = i ? w.x : 1 - w.x, wy = j ? w.y : 1 - w.y;
        n.value += wx * wy * along;
        n.gradient += g * (wx * wy) +
                      Vec2((i ? slope.x : -slope.x) * wy, (j ? slope.y : -slope.y) * wx) * along;
    }
    return n;
}

/// Noise of space, one cell a unit; within sqrt(3)/2 of 0.
TP_HD_NOINLINE Noise3 gradient_noise(const NoiseHash& hash, Vec3 p) {
    const Vec3 cell{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
    const Vec3 f = p - cell;
    const Vec3 w{fade(f.x), fade(f.y), fade(f.z)};
    const Vec3 slope{fade_slope(f.x), fade_slope(f.y), fade_slope(f.z)};
    const uint32_t x = lattice_bits(cell.x), y = lattice_bits(cell.y), z = lattice_bits(cell.z);
    // The hashes by themselves, eight of a kind, which compilers turn into vectors.
    uint32_t bits[8];
    for (uint32_t corner = 0; corner < 8; ++corner)
        bits[corner] =
            lattice_hash(hash, x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2));
    Noise3 n{0, {0, 0, 0}};
    for (uint32_t corner = 0; corner < 8; ++corner) {
        const uint32_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        const Vec3 g = lattice_gradient3(bits[corner]);
        const Vec3 step{static_cast<Real>(i), static_cast<Real>(j), static_cast<Real>(k)};
        const Real along = dot(g, f - step);
        const Real wx = i ? w.x : 1 - w.x, wy = j ? w.y : 1 - w.y, wz = k ? w.z : 1 - w.z;
        n.value += wx * wy * wz * along;
        n.gradient += g * (wx * wy * wz) + Vec3((i ? slope.x : -slope.x) * wy * wz,
                                                (j ? slope.y : -slope.y) * wx * wz,
                                                (k ? slope.z : -slope.z) * wx * wy) *
                                               along;
    }
    return n;
}

/// Sums of noise at growing frequencies (Musgrave in "Texturing and Modeling", chapter 16): each
/// octave has `lacunarity` times the frequency of the last and `gain` times its weight.
struct NoiseOctaves {
    int count = 5;
    Real lacunarity = 2;
    Real gain = Real(0.5);
};

/// The place of the next octave; the shift keeps lattice points from lying on each other.
TP_HD Vec3 next_octave(Vec3 p, const NoiseOctaves& octaves) {
    return p * octaves.lacunarity + Vec3(Real(17.31), Real(5.47), Real(11.83));
}

/// Fractal Brownian motion, as strong as one octave: weights are divided by the root of the sum of
/// their squares, since octaves are independent.
TP_HD Noise3 fbm(const NoiseHash& hash, Vec3 p, const NoiseOctaves& octaves) {
    Noise3 sum{0, {0, 0, 0}};
    Real weight = 1, frequency = 1, squares = 0;
    for (int i = 0; i < octaves.count; ++i) {
        const Noise3 n = gradient_noise(hash, p);
        sum.value += n.value * weight;
        sum.gradient += n.gradient * (weight * frequency);
        squares += weight * weight;
        weight *= octaves.gain;
        frequency *= octaves.lacunarity;
        p = next_octave(p, octaves);
    }
    const Real normal = tp::rsqrt(max(squares, Real(1e-12)));
    return {sum.value * normal, sum.gradient * normal};
}

/// The mean of the octaves' sizes by weight: from 0, where it has creases, to sqrt(3)/2.
TP_HD Real turbulence(const NoiseHash& hash, Vec3 p, const NoiseOctaves& octaves) {
    Real sum = 0, weight = 1, weights = 0;
    for (int i = 0; i < octaves.count; ++i) {
        sum += abs(gradient_noise(hash, p).value) * weight;
        weights += weight;
        weight *= octaves.gain;
        p = next_octave(p, octaves);
    }
    return sum / max(weights, Real(1e-12));
}

/// Musgrave's ridged multifractal, from 0 to 1: the creases of turbulence as ridges, which are
/// rougher the higher they lie.
TP_HD Real ridged_noise(const NoiseHash& hash, Vec3 p, const NoiseOctaves& octaves) {
    Real sum = 0, weight = 1, weights = 0, height = 1;
    for (int i = 0; i < octaves.count; ++i) {
        const Real crease = 1 - min(2 * abs(gradient_noise(hash, p).value), Real(1));
        const Real ridge = crease * crease * height;
        sum += ridge * weight;
        weights += weight;
        weight *= octaves.gain;
        height = min(2 * ridge, Real(1));
        p = next_octave(p, octaves);
    }
    return sum / max(weights, Real(1e-12));
}

}  // namespace tp
