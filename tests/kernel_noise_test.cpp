// Gradient noise: known answers, range and mean, derivatives, spectrum; sums of octaves.
#include <teapath/core/parallel.h>
#include <teapath/kernel/noise.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

using namespace tp;

namespace {

Vec2 vec2(double x, double y) {
    return Vec2(Double2(x, y));
}
Vec3 vec3(double x, double y, double z) {
    return Vec3(Double3(x, y, z));
}

struct Moments {
    double sum = 0, squares = 0, largest = 0;
    int64_t count = 0;

    void add(double x) {
        sum += x;
        squares += x * x;
        largest = std::max(largest, std::abs(x));
        ++count;
    }
    double mean() const { return sum / static_cast<double>(count); }
    double rms() const { return std::sqrt(squares / static_cast<double>(count)); }
};

// Of `count` points in a cube of 1000 cells.
template <class Noise>
Moments moments_of(int count, const Noise& noise) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-500, 500);
    Moments m;
    for (int i = 0; i < count; ++i) {
        const double x = place(random), y = place(random), z = place(random);
        m.add(static_cast<double>(noise(vec3(x, y, z))));
    }
    return m;
}

using Complex = std::complex<double>;

// In place, of a power of two of numbers `stride` apart.
void fourier_transform(Complex* data, size_t size, size_t stride) {
    for (size_t i = 1, j = 0; i < size; ++i) {
        size_t bit = size / 2;
        for (; j & bit; bit /= 2)
            j ^= bit;
        j ^= bit;
        if (i < j) std::swap(data[i * stride], data[j * stride]);
    }
    for (size_t length = 2; length <= size; length *= 2) {
        const Complex turn = std::polar(1.0, -2 * 3.14159265358979323846 / double(length));
        for (size_t first = 0; first < size; first += length) {
            Complex w = 1;
            for (size_t i = 0; i < length / 2; ++i, w *= turn) {
                Complex& a = data[(first + i) * stride];
                Complex& b = data[(first + i + length / 2) * stride];
                const Complex odd = b * w;
                b = a - odd;
                a += odd;
            }
        }
    }
}

// What the power spectrum of a square of noise, 16 pixels a cell, looks like.
struct Spectrum {
    double peak = 0;           // cycles a cell
    double low = 0, fine = 0;  // power below 1/16 and at 2 cycles a cell over that of the peak
    double anisotropy = 0;     // most over least power of 16 sectors, 0.4 to 1.1 cycles a cell
};

Spectrum spectrum_of(const NoiseHash& hash) {
    constexpr size_t kSize = 1024;
    constexpr double kCell = 16;
    std::vector<Complex> data(kSize * kSize);
    for (size_t y = 0; y < kSize; ++y)
        for (size_t x = 0; x < kSize; ++x)
            data[y * kSize + x] = static_cast<double>(
                gradient_noise(hash, vec2(double(x) / kCell, double(y) / kCell)).value);
    for (size_t y = 0; y < kSize; ++y)
        fourier_transform(data.data() + y * kSize, kSize, 1);
    for (size_t x = 0; x < kSize; ++x)
        fourier_transform(data.data() + x, kSize, kSize);

    // Rings of 1/32 cycle a cell, and sectors.
    std::vector<Moments> rings(96);
    std::array<Moments, 16> sectors;
    for (size_t y = 0; y < kSize; ++y)
        for (size_t x = 0; x < kSize; ++x) {
            const auto signed_of = [](size_t i) {
                return i < kSize / 2 ? double(i) : double(i) - double(kSize);
            };
            const double fx = signed_of(x) * kCell / kSize, fy = signed_of(y) * kCell / kSize;
            const double f = std::hypot(fx, fy), power = std::norm(data[y * kSize + x]);
            if (f == 0) continue;
            if (const auto ring = static_cast<size_t>(f * 32); ring < rings.size())
                rings[ring].add(power);
            if (f < 0.4 || f > 1.1) continue;
            double angle = std::atan2(fy, fx);
            if (angle < 0) angle += 3.14159265358979323846;  // the other half is the same
            sectors[std::min<size_t>(static_cast<size_t>(angle / 3.14159265358979323846 * 16), 15)]
                .add(power);
        }
    Spectrum s;
    const auto by_mean = [](const Moments& a, const Moments& b) { return a.mean() < b.mean(); };
    const auto peak = std::max_element(rings.begin(), rings.end(), by_mean);
    s.peak = (double(peak - rings.begin()) + 0.5) / 32;
    s.low = std::max(rings[0].mean(), rings[1].mean()) / peak->mean();
    s.fine = rings[64].mean() / peak->mean();
    const auto [least, most] = std::minmax_element(sectors.begin(), sectors.end(), by_mean);
    s.anisotropy = most->mean() / least->mean();
    return s;
}

}  // namespace

TEST_CASE("AC-N1: noise is 0 at lattice points, keeps its range and reaches far into it") {
    const NoiseHash hash = noise_hash(uint64_t{11});
    for (int i = -50; i < 50; ++i) {
        CHECK(gradient_noise(hash, vec2(i, 3 * i + 1)).value == 0);
        CHECK(gradient_noise(hash, vec3(i, 7 - i, 2 * i)).value == 0);
    }
    const int count = 10'000'000;
    std::array<Moments, 2> found;
    parallel_for(2, 1, [&](int64_t first, int64_t last) {
        for (int64_t i = first; i < last; ++i)
            found[static_cast<size_t>(i)] = moments_of(count, [&](Vec3 p) {
                return i == 0 ? gradient_noise(hash, Vec2(p.x, p.y)).value
                              : gradient_noise(hash, p).value;
            });
    });
    CHECK(found[0].largest <= 0.7072);
    CHECK(found[0].largest >= 0.68);
    CHECK(found[0].rms() > 0.21);
    CHECK(found[0].rms() < 0.22);
    CHECK(found[1].largest <= 0.8661);
    CHECK(found[1].largest >= 0.65);
    // AC-N3
    CHECK(std::abs(found[0].mean()) < 0.002);
    CHECK(std::abs(found[1].mean()) < 0.002);
}

TEST_CASE("noise: known answers, from a program of its own in double") {
    struct Row {
        uint64_t seed;
        int rounds;
        double x, y, z, plane, space;
    };
    const Row rows[] = {
        {0u, 6, 0.5, 0.5, 0.5, -0.030442, 0.089153},
        {0u, 6, -3.25, 7.75, 1.5, 0.029112, 0.354749},
        {1u, 6, 0.25, 0.5, -0.75, 0.135615, -0.009737},
        {1u, 8, 0.25, 0.5, -0.75, -0.401486, -0.334797},
        {1u, 4, 0.25, 0.5, -0.75, -0.369674, 0.012841},
        {7u, 6, 1000.125, -2000.625, 4096.5, 0.346803, -0.294364},
        {2147483647u, 32, 0.5, -0.25, 0.125, -0.454715, -0.160143},
    };
    for (const Row& row : rows) {
        CAPTURE(row.seed);
        CAPTURE(row.rounds);
        const NoiseHash hash = noise_hash(row.seed, row.rounds);
        CHECK(std::abs(double(gradient_noise(hash, vec2(row.x, row.y)).value) - row.plane) < 2e-6);
        CHECK(std::abs(double(gradient_noise(hash, vec3(row.x, row.y, row.z)).value) - row.space) <
              2e-6);
    }
}

TEST_CASE("AC-N2: derivatives of noise, continuous from cell to cell") {
    const NoiseHash hash = noise_hash(uint64_t{3});
    const NoiseOctaves octaves{3, Real(2), Real(0.5)};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-20, 20);
    const double h = 1.0 / 512;  // exact in float, and so are places that are multiples of it
    double worst = 0, worst_fbm = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto on_grid = [&](double x) { return std::round(x / h) * h; };
        const double x = on_grid(place(random)), y = on_grid(place(random)),
                     z = on_grid(place(random));
        const Noise2 plane = gradient_noise(hash, vec2(x, y));
        const Noise3 space = gradient_noise(hash, vec3(x, y, z)),
                     sum = fbm(hash, vec3(x, y, z), octaves);
        for (int axis = 0; axis < 3; ++axis) {
            Double3 step(0);
            step[axis] = h;
            const Vec3 ahead = vec3(x + step.x, y + step.y, z + step.z);
            const Vec3 behind = vec3(x - step.x, y - step.y, z - step.z);
            const auto slope = [&](const auto& noise) {
                return double(noise(ahead) - noise(behind)) / (2 * h);
            };
            const auto of_space = [&](Vec3 p) { return gradient_noise(hash, p).value; };
            const auto of_sum = [&](Vec3 p) { return fbm(hash, p, octaves).value; };
            const auto of_plane = [&](Vec3 p) {
                return gradient_noise(hash, Vec2(p.x, p.y)).value;
            };
            worst = std::max(worst, std::abs(slope(of_space) - double(space.gradient[axis])));
            if (axis < 2)
                worst = std::max(worst, std::abs(slope(of_plane) - double(plane.gradient[axis])));
            worst_fbm = std::max(worst_fbm, std::abs(slope(of_sum) - double(sum.gradient[axis])));
        }
    }
    CHECK(worst < 1e-3);
    CHECK(worst_fbm < 1e-2);  // the third octave is curved sixteen times as much

    // Across a face of cells: the gradient, and its own change.
    for (int i = 0; i < 200; ++i) {
        const double x = std::floor(place(random)), y = place(random), z = place(random);
        const auto slope_at = [&](double along) {
            return Double3(gradient_noise(hash, vec3(x + along, y, z)).gradient);
        };
        const double near = 1.0 / 4096;
        CHECK(glm::length(slope_at(near) - slope_at(-near)) < 8e-3);
        const Double3 change = (slope_at(2 * near) - slope_at(near)) / near;
        const Double3 change_before = (slope_at(-near) - slope_at(-2 * near)) / near;
        CHECK(glm::length(change - change_before) < 0.15);
    }
}

TEST_CASE("AC-N4: the spectrum of noise is a ring, unless the hash is too short") {
    for (const int rounds : {5, 6, 8}) {
        CAPTURE(rounds);
        const Spectrum s = spectrum_of(noise_hash(uint64_t{5}, rounds));
        CHECK(s.peak >= 0.4);
        CHECK(s.peak <= 0.55);
        CHECK(s.low < 0.1);
        CHECK(s.fine < 0.001);
        CHECK(s.anisotropy < 1.5);
    }
    NoiseHash hash = noise_hash(uint64_t{5}, 4);
    CHECK(hash.word == 1);
    CHECK(spectrum_of(hash).anisotropy < 2.5);
    hash.word = 0;
    CHECK(spectrum_of(hash).anisotropy > 4);
    CHECK(noise_hash(uint64_t{5}).word == 0);
    CHECK(noise_hash(uint64_t{5}).rounds == 6);
}

TEST_CASE("noise: sums of octaves keep their range, fBm the strength of one octave") {
    const NoiseHash hash = noise_hash(uint64_t{9});
    const NoiseOctaves one{1, Real(2), Real(0.5)}, five{5, Real(2), Real(0.5)};
    const Vec3 p = vec3(0.3, -1.6, 2.2);
    CHECK(fbm(hash, p, one).value == doctest::Approx(gradient_noise(hash, p).value));
    CHECK(turbulence(hash, p, one) == doctest::Approx(abs(gradient_noise(hash, p).value)));
    const double rms =
        moments_of(100000, [&](Vec3 q) { return gradient_noise(hash, q).value; }).rms();
    const Moments sum = moments_of(100000, [&](Vec3 q) { return fbm(hash, q, five).value; });
    CHECK(std::abs(sum.mean()) < 0.003);
    CHECK(sum.rms() == doctest::Approx(rms).epsilon(0.02));
    const Moments creases = moments_of(100000, [&](Vec3 q) { return turbulence(hash, q, five); });
    CHECK(creases.mean() > 0.1);
    CHECK(creases.largest < 0.8661);
    const Moments ridges = moments_of(100000, [&](Vec3 q) { return ridged_noise(hash, q, five); });
    CHECK(ridges.mean() > 0.2);
    CHECK(ridges.largest <= 1);
    // Far away the lattice ends, and nothing breaks.
    CHECK(std::isfinite(gradient_noise(hash, vec3(1e15, -1e15, 1e12)).value));
}
