#include "makers.h"
#include "noise.h"

#include <teapath/core/parallel.h>

#include <algorithm>

namespace tp {
namespace {

class Ridges {
public:
    explicit Ridges(uint32_t seed) {
        for (uint32_t octave = 0; octave < kOctaves + 2; ++octave)
            noises_.emplace_back(seed * 64 + octave);
    }

    // Noise folded at 0, each octave where the one before stands high (Musgrave, in Ebert et al.,
    // "Texturing and Modeling", chapter 16), on a plane that is bent a little.
    double operator()(Double2 p) const {
        p += Double2(noises_[kOctaves](p * 0.7), noises_[kOctaves + 1](p * 0.7)) * 0.35;
        double sum = 0, amplitude = 0.5, weight = 1;
        for (size_t octave = 0; octave < kOctaves; ++octave) {
            double ridge = 1 - std::abs(noises_[octave](p));
            ridge *= ridge * weight;
            weight = std::clamp(ridge * 2, 0.0, 1.0);
            sum += ridge * amplitude;
            amplitude *= 0.5;
            p = Double2(p.x * 1.6 - p.y * 1.2, p.x * 1.2 + p.y * 1.6);
        }
        return sum;
    }

private:
    static constexpr size_t kOctaves = 8;
    std::vector<Noise2d> noises_;
};

}  // namespace

Mesh make_terrain(ProceduralParameters& p) {
    const Ridges ridges(static_cast<uint32_t>(p.whole("seed", 1, 0, 1'000'000)));
    const double height = p.number("height", 0.25, -10, 10);
    const double scale = p.number("scale", 4, 0.1, 100);
    const int detail = p.whole("detail", 256, 2, 4096), n = detail + 1;
    Mesh mesh;
    const auto count = static_cast<size_t>(n) * static_cast<size_t>(n);
    mesh.positions.resize(count);
    mesh.normals.resize(count);
    mesh.uvs.assign(1, std::vector<Float2>(count));
    const auto at = [&](int i, int j) {
        return static_cast<size_t>(j) * static_cast<size_t>(n) + static_cast<size_t>(i);
    };
    parallel_for(n, 16, [&](int64_t first, int64_t last) {
        for (auto j = static_cast<int>(first); j < static_cast<int>(last); ++j)
            for (int i = 0; i < n; ++i) {
                const Double2 uv(static_cast<double>(i) / detail, static_cast<double>(j) / detail);
                const double y = height * ridges((uv - 0.5) * scale);
                mesh.positions[at(i, j)] = Float3(uv.x - 0.5, y, uv.y - 0.5);
                mesh.uvs[0][at(i, j)] = Float2(uv);
            }
    });
    mesh.triangles.reserve(2 * static_cast<size_t>(detail) * static_cast<size_t>(detail));
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Float3 x = mesh.positions[at(std::min(i + 1, detail), j)] -
                             mesh.positions[at(std::max(i - 1, 0), j)];
            const Float3 z = mesh.positions[at(i, std::min(j + 1, detail))] -
                             mesh.positions[at(i, std::max(j - 1, 0))];
            mesh.normals[at(i, j)] = glm::normalize(glm::cross(z, x));
            if (i == detail || j == detail) continue;
            const auto index = [&](int a, int b) { return static_cast<uint32_t>(at(a, b)); };
            mesh.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
            mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
        }
    return mesh;
}

}  // namespace tp
