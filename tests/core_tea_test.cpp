// The generator against known answers and by its statistics.
#include "support/tea_vectors.h"

#include <teapath/core/tea.h>

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <tuple>
#include <vector>

using namespace tp;
using namespace tp::test;

namespace {

int distance(const TeaKey& a, const TeaKey& b) {
    return std::popcount(a.k0 ^ b.k0) + std::popcount(a.k1 ^ b.k1) + std::popcount(a.k2 ^ b.k2) +
           std::popcount(a.k3 ^ b.k3);
}

// White noise of 1024 x 1024 pixels: word 0 of the pixel's coordinates.
constexpr uint32_t kNoiseSize = 1024;
std::vector<uint32_t> white_noise(int rounds) {
    const TeaKey key = tea_key(0, 1234567890);
    std::vector<uint32_t> noise(kNoiseSize * kNoiseSize);
    for (uint32_t y = 0; y < kNoiseSize; ++y)
        for (uint32_t x = 0; x < kNoiseSize; ++x)
            noise[y * kNoiseSize + x] = tea_encrypt(TeaBlock{x, y}, key, rounds).v0;
    return noise;
}

double noise_mean(const std::vector<uint32_t>& noise) {
    double sum = 0;
    for (const uint32_t bits : noise)
        sum += static_cast<double>(unit_real(bits));
    return sum / static_cast<double>(noise.size());
}

// Correlation of pixels (dx, dy) apart.
double lag_correlation(const std::vector<uint32_t>& noise, uint32_t dx, uint32_t dy) {
    double product = 0, square = 0;
    for (uint32_t y = 0; y < kNoiseSize; ++y) {
        for (uint32_t x = 0; x < kNoiseSize; ++x) {
            const uint32_t i = y * kNoiseSize + x;
            const uint32_t j = (y + dy) % kNoiseSize * kNoiseSize + (x + dx) % kNoiseSize;
            const double a = noise[i] * 0x1p-32 - 0.5, b = noise[j] * 0x1p-32 - 0.5;
            product += a * b;
            square += a * a;
        }
    }
    return product / square;
}

// Chi squared of the 256 values of a byte.
double byte_chi2(const std::vector<uint32_t>& noise, uint32_t shift) {
    std::array<double, 256> count{};
    for (const uint32_t bits : noise)
        count[bits >> shift & 255] += 1;
    const double expected = static_cast<double>(noise.size()) / 256;
    double chi2 = 0;
    for (const double n : count)
        chi2 += (n - expected) * (n - expected) / expected;
    return chi2;
}

// AC-T6 as a predicate, so that it can be shown to fail.
bool is_white(int rounds) {
    const std::vector<uint32_t> noise = white_noise(rounds);
    bool white = std::abs(noise_mean(noise) - 0.5) < 0.0015;
    const uint32_t lags[][2] = {{1, 0}, {0, 1}, {1, 1}, {4, 0}};
    for (const auto& lag : lags)
        white &= std::abs(lag_correlation(noise, lag[0], lag[1])) < 0.004;
    for (const uint32_t shift : {0u, 24u}) {
        const double chi2 = byte_chi2(noise, shift);
        white &= chi2 >= 175 && chi2 <= 350;
    }
    return white;
}

}  // namespace

TEST_CASE("AC-T1: TEA gives the known words") {
    for (const TeaVector& v : tea_vectors()) {
        CAPTURE(v.rounds);
        CHECK(tea_encrypt(v.block, v.key, v.rounds) == v.after);
        CHECK(tea_encrypt_unrolled(v.block, v.key, v.rounds) == v.after);
        CHECK(tea_decrypt(v.after, v.key, v.rounds) == v.block);
    }
    CHECK(tea_vectors().size() == 30);
}

TEST_CASE("AC-T1, E1: the listing without the sum gives its own words") {
    const TeaBlock after[] = {{0x7b850f74, 0x275409f9},
                              {0x56450c34, 0x12d3aa9d},
                              {0x63d2b41c, 0x7573bdb1},
                              {0x1b5b2ada, 0x35648376},
                              {0x3bfda859, 0x312aa3ab}};
    for (int i = 0; i < 5; ++i) {
        const int rounds = kVectorRounds[i];
        CHECK(literal_encrypt({0, 0}, tea_initial_key(), rounds) == after[i]);
        CHECK(tea_encrypt({0, 0}, tea_initial_key(), rounds) != after[i]);
        CHECK(literal_encrypt({0, 0}, TeaKey{}, rounds) == TeaBlock{0, 0});  // a fixed point
    }
    // Its rounds are alike, so they compose; those of TEA are not.
    const TeaBlock block{12345, 7};
    const TeaKey key = tea_initial_key();
    CHECK(literal_encrypt(literal_encrypt(block, key, 3), key, 5) ==
          literal_encrypt(block, key, 8));
    CHECK(tea_encrypt(tea_encrypt(block, key, 3), key, 5) != tea_encrypt(block, key, 8));
}

TEST_CASE("AC-T2: Wheeler's chain of 64 encryptions") {
    // Six words in a ring; a step encrypts two by the next four, then the window moves by one.
    TeaBlock v{0, 0};
    TeaKey k;
    for (int step = 0; step < 64; ++step) {
        if (step > 0) {
            const TeaBlock last = v;
            v = {last.v1, k.k0};
            k = {k.k1, k.k2, k.k3, last.v0};
        }
        v = tea_encrypt(v, k, 32);
        if (step == 0) CHECK(v == TeaBlock{0x41ea3a0a, 0x94baa940});
        if (step == 1) CHECK(v == TeaBlock{0x4e8e7829, 0x7d8236d8});
    }
    CHECK(v == TeaBlock{0x2bb0f1b3, 0xc023ed11});
    CHECK(k == TeaKey{0x5c60bff2, 0x7072d01c, 0x4513c5eb, 0x8f3a38ab});
}

TEST_CASE("AC-T3: what is encrypted decrypts, equivalent keys encrypt alike") {
    std::mt19937 random(1);
    const auto word = [&] { return static_cast<uint32_t>(random()); };
    const uint32_t top = 0x80000000u;
    int not_inverse = 0, not_unrolled = 0, not_equivalent = 0, like_literal = 0;
    for (int i = 0; i < 1000000; ++i) {
        const TeaKey key{word(), word(), word(), word()};
        const TeaBlock block{word(), word()};
        const int rounds = 1 + static_cast<int>(word() % 32);
        const TeaBlock after = tea_encrypt(block, key, rounds);
        not_inverse += tea_decrypt(after, key, rounds) != block;
        not_unrolled += tea_encrypt_unrolled(block, key, rounds) != after;
        like_literal += after == literal_encrypt(block, key, rounds);
        const TeaKey others[] = {{key.k0 ^ top, key.k1 ^ top, key.k2, key.k3},
                                 {key.k0, key.k1, key.k2 ^ top, key.k3 ^ top},
                                 {key.k0 ^ top, key.k1 ^ top, key.k2 ^ top, key.k3 ^ top}};
        const TeaKey& other = others[i % 3];
        not_equivalent += tea_encrypt(block, other, rounds) != after;
        not_equivalent += canonical(other) != canonical(key);
    }
    CHECK(not_inverse == 0);
    CHECK(not_unrolled == 0);
    CHECK(not_equivalent == 0);
    CHECK(like_literal == 0);
}

TEST_CASE("AC-T4: keys of devices and seeds") {
    for (const TeaKeyVector& v : tea_key_vectors())
        CHECK(tea_key(v.device, v.seed) == v.key);

    // The listing without the sum gives another key.
    const TeaKey ik = tea_initial_key();
    const TeaBlock a = literal_encrypt({0, 1234567890}, ik, 16);
    const TeaBlock b = literal_encrypt({0, 1234567890}, {ik.k1, a.v0, ik.k3, a.v1}, 16);
    CHECK(TeaKey{b.v0, a.v0, b.v1, a.v1} == TeaKey{0x04f6702f, 0x5128410e, 0x1c9ebd01, 0x7ad38e3a});
}

TEST_CASE("AC-T4: rounds of keys are clamped to [6, 32], the seed's high half counts") {
    CHECK(tea_key(3, 5, 0) == tea_key(3, 5, 6));
    CHECK(tea_key(3, 5, -1) == tea_key(3, 5, 6));
    CHECK(tea_key(3, 5, 5) == tea_key(3, 5, 6));
    CHECK(tea_key(3, 5, 1000) == tea_key(3, 5, 32));
    CHECK(tea_key(3, 5, 6) != tea_key(3, 5, 7));
    CHECK(tea_key(3, 5, 32) != tea_key(3, 5, 31));
    const uint64_t high = uint64_t{1} << 32;
    CHECK(tea_key(3, 5) != tea_key(3, 5 + high));
    CHECK(tea_key(3, 5 + high) != tea_key(3, 5 + 2 * high));
}

TEST_CASE("AC-T4: 16384 keys are distinct, neighbours differ in half of their bits") {
    std::set<std::tuple<uint32_t, uint32_t, uint32_t, uint32_t>> keys;
    double sum = 0;
    int pairs = 0;
    for (const uint64_t seed :
         {uint64_t{0}, uint64_t{1}, uint64_t{1234567890}, uint64_t{1} << 40}) {
        for (uint32_t device = 0; device < 4096; ++device) {
            const TeaKey key = tea_key(device, seed);
            const TeaKey k = canonical(key);
            keys.emplace(k.k0, k.k1, k.k2, k.k3);
            if (device == 0) continue;
            sum += distance(key, tea_key(device - 1, seed));
            ++pairs;
        }
    }
    CHECK(keys.size() == 16384);
    CHECK(sum / pairs > 63);
    CHECK(sum / pairs < 65);
}

TEST_CASE("the first words of two devices' streams") {
    const TeaKey first = tea_key(0, 1234567890), second = tea_key(1, 1234567890);
    CHECK(tea_encrypt<8>({0, 0}, first) == TeaBlock{0x2b3352ad, 0xcd269278});
    CHECK(tea_encrypt<8>({1, 0}, first) == TeaBlock{0xa385af81, 0x45003fa0});
    CHECK(tea_encrypt<8>({0, 0}, second) == TeaBlock{0x3f9028b7, 0x1b5e8afe});
    CHECK(tea_encrypt<8>({1, 0}, second) == TeaBlock{0xedd5d3fa, 0x116cb752});
}

TEST_CASE("the numbers of the OptiX SDK's samples") {
    OptixRandom zero = optix_random<16>(0, 0), numbers = zero;
    CHECK(zero.state == 0x741c187d);
    for (const uint32_t expected : {0xd2ffb8u, 0x013fb7u, 0xc119aau, 0x10fd01u})
        CHECK(zero.next_bits() == expected);
    for (const double expected : {0.82421446, 0.00487846, 0.75429785, 0.06636053})
        CHECK(std::abs(static_cast<double>(numbers.next()) - expected) < 1e-8);
    OptixRandom pixel = optix_random<4>(12345, 7);
    CHECK(pixel.state == 0x75130546);
    for (const uint32_t expected : {0x561bedu, 0x13cc68u, 0x09c4a7u, 0x9779dau})
        CHECK(pixel.next_bits() == expected);
}

TEST_CASE("AC-T6: pixels' numbers are white from 6 rounds on; at 4 the test finds otherwise") {
    CHECK(is_white(6));
    CHECK(is_white(8));
    CHECK_FALSE(is_white(4));
}

TEST_CASE("AC-T9: no bits become 1") {
    bool in_range = true, rises = true;
    Real last = -1;
    for (uint32_t mantissa = 0; mantissa < 1u << 24; ++mantissa) {
        const Real low = unit_real(mantissa << 8), high = unit_real(mantissa << 8 | 255);
        in_range &= low >= 0 && high < 1;
        rises &= low > last && high >= low;
        last = high;
    }
    CHECK(in_range);
    CHECK(rises);
    CHECK(unit_real(0) == 0);
    CHECK(unit_real(0x80000000u) == Real(0.5));
}
