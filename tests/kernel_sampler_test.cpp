// The samplers: counters that never meet, Sobol points that are nets, estimates without bias and
// with less noise.
#include "support/chi2.h"
#include "support/scene_maker.h"

#include <teapath/kernel/dimensions.h>
#include <teapath/kernel/sampler.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <set>
#include <utility>
#include <vector>

using namespace tp;
using namespace tp::test;

namespace {

constexpr uint64_t kOverflow = uint64_t{1} << kSampleBits;

Sampler sampler_of(SamplerKind kind, uint32_t pixel, uint64_t sample, uint64_t seed = 0) {
    return make_sampler(tea_key(0, seed), pixel, sample, kind, 8);
}

Vec2 sobol_2d(uint32_t pixel, uint64_t sample, uint32_t dimension, uint64_t seed = 0) {
    return sample_2d<true>(sampler_of(SamplerKind::Sobol, pixel, sample, seed), dimension);
}

// The words that the pairs of these samples, pixels and dimensions get, as a set: a cipher with one
// key gives two counters two blocks.
using Words = std::set<std::pair<uint32_t, uint32_t>>;

// How often so uneven a share of cells would come by chance, where cells are pairs of a number of
// 2^18 pixels and samples and of its neighbour (the second of the pair, or what lies `pixels`,
// `samples`, `dimensions` and `seeds` away).
struct Neighbour {
    uint32_t pixels, samples, dimensions, seeds;
};
double independence(const Neighbour& n, int rounds) {
    const TeaKey key = tea_key(0, 3), other_key = tea_key(0, 3 + n.seeds);
    std::vector<double> cells(256);
    for (uint32_t pixel = 0; pixel < 512; ++pixel) {
        for (uint32_t sample = 0; sample < 512; ++sample) {
            const Sampler a = make_sampler(key, pixel, sample, SamplerKind::Tea, rounds);
            const Sampler b = make_sampler(other_key, pixel + n.pixels, sample + n.samples,
                                           SamplerKind::Tea, rounds);
            const auto slot = [](Real u) { return static_cast<size_t>(u * 16); };
            const Real u = sample_1d<false>(a, 8), v = sample_1d<false>(b, 8 + n.dimensions);
            ++cells[slot(u) * 16 + slot(v)];
        }
    }
    return chi2_test_uniform(cells).p_value;
}

// True if each box of the 2^k that a division into 2^a columns makes holds one of the points.
bool is_net(const std::vector<TeaBlock>& points, int k) {
    for (int a = 0; a <= k; ++a) {
        std::vector<int> boxes(size_t{1} << k);
        for (const TeaBlock& p : points) {
            const uint64_t x = uint64_t{p.v0} >> (32 - a), y = uint64_t{p.v1} >> (32 - (k - a));
            ++boxes[x << (k - a) | y];
        }
        if (std::count(boxes.begin(), boxes.end(), 1) != int64_t{1} << k) return false;
    }
    return true;
}

double smooth(Vec2 u) {
    return std::exp(-static_cast<double>(u.x)) * std::cos(1.5 * static_cast<double>(u.y));
}
const double kSmoothIntegral = (1 - std::exp(-1.0)) * std::sin(1.5) / 1.5;

struct Errors {
    double bias = 0;  // in standard errors
    double rms = 0;
};
Errors errors(SamplerKind kind, uint32_t samples) {
    constexpr int kSeeds = 400;
    double sum = 0, squares = 0;
    for (int seed = 0; seed < kSeeds; ++seed) {
        double mean = 0;
        for (uint32_t i = 0; i < samples; ++i)
            mean += smooth(sample_2d<true>(sampler_of(kind, 7, i, static_cast<uint64_t>(seed)), 8));
        const double error = mean / samples - kSmoothIntegral;
        sum += error;
        squares += error * error;
    }
    return {sum / std::sqrt(squares), std::sqrt(squares / kSeeds)};
}

// Variance of a pixel, from two independent pictures.
double variance(const FilmImage& a, const FilmImage& b) {
    double sum = 0;
    for (size_t i = 0; i < a.radiance.size(); ++i) {
        const double difference = static_cast<double>(a.radiance[i] - b.radiance[i]);
        sum += difference * difference / 2;
    }
    return sum / static_cast<double>(a.radiance.size());
}

}  // namespace

TEST_CASE("TEA: no two of pixel, sample and dimension share a block") {
    Words words;
    size_t count = 0;
    for (uint32_t pixel = 0; pixel < 40; ++pixel) {
        for (uint64_t sample = 0; sample < 40; ++sample) {
            const Sampler s = sampler_of(SamplerKind::Tea, pixel, sample);
            for (uint32_t dimension = 0; dimension < 80; dimension += 2, ++count) {
                const TeaBlock block = sample_block<false>(s, dimension);
                words.emplace(block.v0, block.v1);
            }
        }
    }
    CHECK(words.size() == count);

    // Nor do those where a field is full, or runs over.
    words.clear();
    count = 0;
    for (const uint32_t pixel : {0u, 1u, 0x7fffffffu, 0xffffffffu}) {
        for (const uint64_t sample :
             {uint64_t{0}, uint64_t{1}, kOverflow - 1, kOverflow, kOverflow + 1, 2 * kOverflow,
              (uint64_t{1} << 32) - 1, uint64_t{1} << 32, uint64_t{1} << 40}) {
            const Sampler s = sampler_of(SamplerKind::Tea, pixel, sample);
            for (const uint32_t pair : {0u, 1u, 4095u, 4096u, 4097u, 8192u, 50000u}) {
                const TeaBlock block = sample_block<false>(s, 2 * pair);
                words.emplace(block.v0, block.v1);
                ++count;
            }
        }
    }
    CHECK(words.size() == count);
}

TEST_CASE("TEA: pixel, sample and pair make the counter, what runs over makes another key") {
    const TeaKey key = tea_key(0, 0);
    const auto block = [](uint64_t sample, uint32_t pair) {
        return sample_block<false>(sampler_of(SamplerKind::Tea, 3, sample), 2 * pair);
    };
    CHECK(block(9, 6) == tea_encrypt({3, 9u << 12 | 6u}, key, 8));
    CHECK(block(kOverflow - 1, 4095) == tea_encrypt({3, 0xffffffffu}, key, 8));
    const TeaKey late = derive_key({5, 2}, key, 16), deep = derive_key({7, 3}, key, 16);
    CHECK(block(5 * kOverflow + 9, 6) == tea_encrypt({3, 9u << 12 | 6u}, late, 8));
    CHECK(block(9, 7 * 4096 + 6) == tea_encrypt({3, 9u << 12 | 6u}, deep, 8));
    CHECK(block(5 * kOverflow + 9, 7 * 4096 + 6) ==
          tea_encrypt({3, 9u << 12 | 6u}, derive_key({7, 3}, late, 16), 8));

    // The pair's words are its two dimensions; without code for Sobol the kind does not matter.
    for (const SamplerKind kind : {SamplerKind::Tea, SamplerKind::Sobol}) {
        const Sampler s = sampler_of(kind, 3, 9);
        const Vec2 u = sample_2d<false>(s, 12);
        CHECK(u.x == unit_real(block(9, 6).v0));
        CHECK(u.y == unit_real(block(9, 6).v1));
        CHECK(sample_1d<false>(s, 12) == u.x);
        CHECK(sample_1d<false>(s, 13) == u.y);
    }
}

TEST_CASE("TEA: numbers are uniform, and independent of their neighbours") {
    constexpr Neighbour kNeighbours[] = {{0, 0, 1, 0}, {1, 0, 0, 0}, {1280, 0, 0, 0}, {0, 1, 0, 0},
                                         {0, 0, 2, 0}, {0, 0, 8, 0}, {1, 1, 0, 0},    {0, 0, 0, 1}};
    for (const int rounds : {6, 8})
        for (const Neighbour& n : kNeighbours)
            CHECK(independence(n, rounds) > sidak(0.01, 2 * 8));
    for (const Neighbour& n : {kNeighbours[1], kNeighbours[3]})
        CHECK(independence(n, 2) < 1e-9);
}

TEST_CASE("dimensions of a vertex lie apart from those of the camera and of other vertices") {
    CHECK(kDimensionTime < vertex_dimension(1));
    CHECK(kDimensionOpacity < vertex_dimension(2) - vertex_dimension(1));
    for (const uint32_t pair : {kDimensionPixel, kDimensionLens, kDimensionBsdf, kDimensionLight})
        CHECK(pair % 2 == 0);
}

TEST_CASE("Sobol: both coordinates by their usual definition") {
    uint32_t direction[32];  // second coordinate: primitive polynomial x + 1
    direction[0] = 0x80000000u;
    for (int i = 1; i < 32; ++i)
        direction[i] = direction[i - 1] ^ direction[i - 1] >> 1;
    const TeaKey key = tea_key(0, 4);
    for (uint32_t i = 0; i < 4096; ++i) {
        const uint32_t index = i < 2048 ? i : tea_encrypt({i, 0}, key, 8).v0;
        uint32_t expected = 0;
        for (int bit = 0; bit < 32; ++bit)
            if (index >> bit & 1) expected ^= direction[bit];
        REQUIRE(reverse_bits(pascal_product(index)) == expected);
    }
}

TEST_CASE("Sobol: scrambling is nested, and flips each bit half of the time") {
    // Two numbers that differ first at a bit still do, whatever the seed.
    const TeaKey key = tea_key(0, 5);
    for (uint32_t i = 0; i < 10000; ++i) {
        const TeaBlock r = tea_encrypt({i, 0}, key, 8), seed = tea_encrypt({i, 1}, key, 8);
        const uint32_t bit = i % 32, low = (1u << bit) - 1;
        const uint32_t other = (r.v0 & low) | (~r.v0 & (1u << bit)) | (r.v1 & ~low & ~(1u << bit));
        const uint32_t difference =
            scramble_reversed(r.v0, seed.v0) ^ scramble_reversed(other, seed.v0);
        REQUIRE((difference & low) == 0);
        REQUIRE((difference >> bit & 1) == 1);
    }
    // The place of one point over seeds, and the places of two, are uniform.
    for (const uint32_t index : {0u, 1u, 2u, 3u, 100u, 1000000u}) {
        std::vector<double> cells(256), pairs(256);
        for (uint64_t seed = 0; seed < 20000; ++seed) {
            const Vec2 a = sobol_2d(1, index, 8, seed), b = sobol_2d(1, index, 10, seed);
            const auto slot = [](Real u) { return static_cast<size_t>(u * 16); };
            ++cells[slot(a.x) * 16 + slot(a.y)];
            ++pairs[slot(a.x) * 16 + slot(b.x)];
        }
        CHECK(chi2_test_uniform(cells).p_value > sidak(0.01, 12));
        CHECK(chi2_test_uniform(pairs).p_value > sidak(0.01, 12));
    }
}

TEST_CASE("Sobol: aligned blocks of 2^k points are (0, k, 2)-nets, beyond 2^20 samples too") {
    for (const uint64_t block : {uint64_t{0}, uint64_t{1}, uint64_t{5}}) {
        for (const uint32_t pixel : {0u, 17u, 2000000u}) {
            for (const uint32_t dimension : {0u, 8u, 26u, 8192u, 20000u}) {
                for (const int k : {0, 1, 2, 5, 10}) {
                    std::vector<TeaBlock> points;
                    for (uint64_t i = 0; i < uint64_t{1} << k; ++i)
                        points.push_back(sample_block<true>(
                            sampler_of(SamplerKind::Sobol, pixel, (block << k) + i), dimension));
                    CHECK(is_net(points, k));
                }
            }
        }
    }
    // The first 2^21 samples: strata of one coordinate of which each half would miss some.
    std::vector<bool> seen(size_t{1} << 21);
    const SobolSeed seed{0x12345678u, 0x9abcdef0u, 0x31415926u};
    for (uint32_t i = 0; i < 1u << 21; ++i)
        seen[sobol_point(i, seed).y >> 11] = true;
    CHECK(std::count(seen.begin(), seen.end(), true) == 1 << 21);
    const Sampler late = sampler_of(SamplerKind::Sobol, 3, kOverflow + 5);
    CHECK(late.sample == kOverflow + 5);
    CHECK(late.key == tea_key(0, 0));
    // The index is whole up to 2^32; then another key makes another sequence.
    const uint64_t huge = uint64_t{1} << 32;
    CHECK(sampler_of(SamplerKind::Sobol, 3, huge).key != tea_key(0, 0));
    CHECK(sobol_2d(3, huge, 8) != sobol_2d(3, 0, 8));
}

TEST_CASE("Sobol: pairs and pixels have sequences of their own, uncorrelated") {
    const auto correlation = [](auto&& a, auto&& b) {
        double sum = 0;
        constexpr uint32_t kCount = 4096;
        for (uint32_t i = 0; i < kCount; ++i)
            sum += (static_cast<double>(a(i)) - 0.5) * (static_cast<double>(b(i)) - 0.5);
        return 12 * sum / kCount;
    };
    const auto u = [](uint32_t i) { return sobol_2d(5, i, 8).x; };
    CHECK(std::abs(correlation(u, [](uint32_t i) { return sobol_2d(5, i, 8).y; })) < 0.06);
    CHECK(std::abs(correlation(u, [](uint32_t i) { return sobol_2d(5, i, 10).x; })) < 0.06);
    CHECK(std::abs(correlation(u, [](uint32_t i) { return sobol_2d(5, i, 10).y; })) < 0.06);
    CHECK(std::abs(correlation(u, [](uint32_t i) { return sobol_2d(6, i, 8).x; })) < 0.06);
    CHECK(std::abs(correlation(u, [](uint32_t i) { return sobol_2d(5, i, 8, 1).x; })) < 0.06);
    CHECK(correlation(u, u) > 0.99);
}

TEST_CASE("Sobol: no bias, and an error that falls much faster than TEA's") {
    const Errors tea_few = errors(SamplerKind::Tea, 64), tea_many = errors(SamplerKind::Tea, 1024);
    const Errors few = errors(SamplerKind::Sobol, 64), many = errors(SamplerKind::Sobol, 1024);
    for (const Errors& e : {tea_few, tea_many, few, many})
        CHECK(std::abs(e.bias) < 4);
    CHECK(tea_few.rms / tea_many.rms == doctest::Approx(4).epsilon(0.2));  // n^-1/2
    CHECK(few.rms / many.rms > 16);                                        // beyond n^-1
    CHECK(few.rms < tea_few.rms / 10);
    CHECK(many.rms < tea_many.rms / 100);
}

TEST_CASE("a render by Sobol has the mean of one by TEA, and less noise") {
    SceneMaker maker;
    maker.background(0);
    maker.camera().look_from = {0, 1.5, 5};
    maker.camera().look_at = {0, 0.5, 0};
    maker.object(XzRectShape{{-5, -5}, {5, 5}, 0}, maker.lambertian(0.6));
    maker.sphere({-0.7, 0.6, 0}, 0.6, maker.lambertian(0.7));
    maker.sphere({0.7, 0.6, 0}, 0.6, maker.metal(0.8, 0.3));
    maker.object(XzRectShape{{-1, -1}, {1, 1}, 3}, maker.light(6)).inside_out = true;
    const auto with = [&](SamplerKind kind, uint64_t seed) {
        maker.path().sampler = kind;
        maker.path().seed = seed;
        return render(maker.scene, 64);
    };
    const FilmImage tea = with(SamplerKind::Tea, 1), tea_again = with(SamplerKind::Tea, 2);
    const FilmImage sobol = with(SamplerKind::Sobol, 1), again = with(SamplerKind::Sobol, 2);
    CHECK(mean(sobol) == doctest::Approx(mean(tea)).epsilon(0.005));
    CHECK(mean(again) == doctest::Approx(mean(tea_again)).epsilon(0.005));
    CHECK(variance(sobol, again) < 0.5 * variance(tea, tea_again));
}
