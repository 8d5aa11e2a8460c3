// Samplers: counters that never meet, nets that are stratified, estimates without bias.
#include "support/scene_maker.h"

#include <teapath/kernel/sampler.h>

#include <array>
#include <cmath>
#include <set>
#include <tuple>

using namespace tp;
using namespace tp::test;

namespace {

Sampler sampler_of(uint32_t pixel, uint64_t sample, SamplerKind kind, uint64_t seed = 0) {
    return make_sampler(tea_key(0, seed), pixel, sample, kind, 8);
}

// Root mean square error of the mean of a smooth function over seeds.
double rmse(SamplerKind kind, uint32_t samples) {
    double squares = 0;
    constexpr int kSeeds = 200;
    for (int seed = 0; seed < kSeeds; ++seed) {
        double sum = 0;
        for (uint32_t i = 0; i < samples; ++i) {
            const Vec2 u = sample_2d<true>(sampler_of(7, i, kind, static_cast<uint64_t>(seed)), 8);
            sum += std::exp(-static_cast<double>(u.x)) * std::cos(1.5 * static_cast<double>(u.y));
        }
        const double exact = (1 - std::exp(-1.0)) * std::sin(1.5) / 1.5;
        squares += std::pow(sum / samples - exact, 2);
    }
    return std::sqrt(squares / kSeeds);
}

double pixel_variance(const FilmImage& a, const FilmImage& b) {
    double sum = 0;
    for (size_t i = 0; i < a.radiance.size(); ++i)
        sum += std::pow(static_cast<double>(a.radiance[i] - b.radiance[i]), 2) / 2;
    return sum / static_cast<double>(a.radiance.size());
}

}  // namespace

TEST_CASE(
    "no two of pixel, sample and dimension share a block, and what overflows changes the key") {
    std::set<std::tuple<uint32_t, uint32_t, uint32_t, uint32_t>> blocks;
    int count = 0;
    for (const uint64_t sample : {uint64_t{0}, uint64_t{1}, uint64_t{4095}, (uint64_t{1} << 20) - 1,
                                  uint64_t{1} << 20, (uint64_t{1} << 20) + 1, uint64_t{1} << 40}) {
        for (const uint32_t dimension : {0u, 2u, 8u, 8190u, 8192u, 8194u, 100000u}) {
            for (const uint32_t pixel : {0u, 1u, 1u << 20}) {
                const Sampler s = sampler_of(pixel, sample, SamplerKind::Tea);
                const TeaBlock out = sample_block(s, dimension);
                blocks.insert({out.v0, out.v1, 0, 0});
                ++count;
            }
        }
    }
    CHECK(blocks.size() == static_cast<size_t>(count));
    CHECK(sampler_of(0, 5, SamplerKind::Tea).key == tea_key(0, 0));
    CHECK(!(sampler_of(0, uint64_t{1} << 20, SamplerKind::Tea).key == tea_key(0, 0)));
}

TEST_CASE("a pair is one call: two dimensions are the two words") {
    const Sampler s = sampler_of(3, 9, SamplerKind::Tea);
    const Vec2 pair = sample_2d<false>(s, 12);
    CHECK(sample_1d<false>(s, 12) == pair.x);
    CHECK(sample_1d<false>(s, 13) == pair.y);
    const TeaBlock expected = tea_encrypt({3, 9u << 12 | 6u}, tea_key(0, 0), 8);
    CHECK(pair.x == unit_real(expected.v0));
    CHECK(pair.y == unit_real(expected.v1));
}

TEST_CASE("Sobol: the first 2^k points of a pair are a (0, k, 2)-net in base 2") {
    for (const uint32_t pixel : {0u, 17u}) {
        for (const uint32_t dimension : {0u, 8u, 26u}) {
            for (int k = 1; k <= 10; ++k) {
                for (int a = 0; a <= k; ++a) {
                    std::vector<int> cells(size_t{1} << k, 0);
                    for (uint32_t i = 0; i < 1u << k; ++i) {
                        const Vec2 u =
                            sample_2d<true>(sampler_of(pixel, i, SamplerKind::Sobol), dimension);
                        const auto x = static_cast<uint32_t>(u.x * static_cast<Real>(1 << a));
                        const auto y = static_cast<uint32_t>(u.y * static_cast<Real>(1 << (k - a)));
                        ++cells[x << (k - a) | y];
                    }
                    CHECK(std::all_of(cells.begin(), cells.end(), [](int n) { return n == 1; }));
                }
            }
        }
    }
}

TEST_CASE("Sobol: unbiased over seeds, and its error falls much faster than that of TEA") {
    const double tea_64 = rmse(SamplerKind::Tea, 64), sobol_64 = rmse(SamplerKind::Sobol, 64);
    const double tea_1024 = rmse(SamplerKind::Tea, 1024),
                 sobol_1024 = rmse(SamplerKind::Sobol, 1024);
    CHECK(sobol_64 < tea_64 / 8);
    CHECK(sobol_1024 < tea_1024 / 40);
    CHECK(tea_64 / tea_1024 == doctest::Approx(4).epsilon(0.25));  // 1 / sqrt(n)
    double sum = 0;
    for (uint64_t seed = 0; seed < 4000; ++seed)
        sum +=
            static_cast<double>(sample_2d<true>(sampler_of(1, 3, SamplerKind::Sobol, seed), 8).x);
    CHECK(std::abs(sum / 4000 - 0.5) < 4 * std::sqrt(1.0 / 12 / 4000));
}

TEST_CASE("a render with Sobol has the mean of one with TEA and less noise") {
    SceneMaker maker;
    maker.background(0);
    maker.camera().look_from = {0, 1.5, 5};
    maker.camera().look_at = {0, 0.5, 0};
    maker.object(XzRectShape{{-5, -5}, {5, 5}, 0}, maker.lambertian(0.6));
    maker.sphere({0, 0.6, 0}, 0.6, maker.lambertian(0.7));
    maker.object(XzRectShape{{-1, -1}, {1, 1}, 3}, maker.light(6)).inside_out = true;
    const auto with = [&](SamplerKind kind, uint64_t seed) {
        maker.path().sampler = kind;
        maker.path().seed = seed;
        return render(maker.scene, 64);
    };
    const FilmImage tea = with(SamplerKind::Tea, 1), tea2 = with(SamplerKind::Tea, 2);
    const FilmImage sobol = with(SamplerKind::Sobol, 1), sobol2 = with(SamplerKind::Sobol, 2);
    CHECK(mean(sobol) == doctest::Approx(mean(tea)).epsilon(0.005));
    CHECK(pixel_variance(sobol, sobol2) < 0.5 * pixel_variance(tea, tea2));
}
