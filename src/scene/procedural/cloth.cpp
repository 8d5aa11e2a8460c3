#include "makers.h"
#include "noise.h"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

// A square sheet of threads that falls over a ball of radius 0.5 on the floor: particles by
// Verlet's method, threads as distances that are restored (Jakobsen, "Advanced Character Physics",
// 2001).
class Sheet {
public:
    Sheet(int detail, uint32_t seed) : Sheet(detail) {
        const Noise2d noise(seed);
        const double aside = 0.1 * noise({0.5, 0.37});
        for (int j = 0; j < n_; ++j)
            for (int i = 0; i < n_; ++i) {
                const Double2 p{(i * rest_) - kSide / 2, (j * rest_) - kSide / 2};
                const double ripple = 0.01 * noise(p * 5.0);
                now_.push_back({p.x + aside, 1.15 + ripple, p.y});
            }
        before_ = now_;
    }

    void fall(int steps) {
        for (int step = 0; step < steps; ++step) {
            move();
            for (int k = 0; k < 12; ++k) {
                restore(step + k);
                collide();
            }
        }
    }

    // The same at rest, with a thread between each two.
    Sheet refined() const {
        Sheet fine(2 * (n_ - 1));
        for (int j = 0; j < fine.n_; ++j)
            for (int i = 0; i < fine.n_; ++i)
                fine.now_.push_back((now_[at(i / 2, j / 2)] + now_[at((i + 1) / 2, j / 2)] +
                                     now_[at(i / 2, (j + 1) / 2)] +
                                     now_[at((i + 1) / 2, (j + 1) / 2)]) *
                                    0.25);
        fine.before_ = fine.now_;
        return fine;
    }

    Mesh mesh() const {
        Mesh mesh;
        mesh.uvs.emplace_back();
        for (int j = 0; j < n_; ++j)
            for (int i = 0; i < n_; ++i) {
                mesh.positions.push_back(Float3(now_[at(i, j)]));
                const Double3 du =
                    now_[at(std::min(i + 1, n_ - 1), j)] - now_[at(std::max(i - 1, 0), j)];
                const Double3 dv =
                    now_[at(i, std::min(j + 1, n_ - 1))] - now_[at(i, std::max(j - 1, 0))];
                mesh.normals.push_back(Float3(glm::normalize(glm::cross(dv, du))));
                mesh.uvs[0].push_back(Float2(static_cast<float>(i) / static_cast<float>(n_ - 1),
                                             static_cast<float>(j) / static_cast<float>(n_ - 1)));
            }
        for (int j = 0; j + 1 < n_; ++j)
            for (int i = 0; i + 1 < n_; ++i) {
                const auto index = [&](int x, int y) { return static_cast<uint32_t>(at(x, y)); };
                mesh.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
                mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
            }
        return mesh;
    }

private:
    static constexpr double kSide = 2.2, kBall = 0.5, kFloor = 0.01;
    explicit Sheet(int detail) : n_(detail + 1), rest_(kSide / detail) {}
    size_t at(int i, int j) const { return static_cast<size_t>(j * n_ + i); }

    void move() {
        constexpr double kStep = 1.0 / 90, kDamping = 0.985;
        for (size_t i = 0; i < now_.size(); ++i) {
            const Double3 old = now_[i];
            now_[i] += (now_[i] - before_[i]) * kDamping + Double3(0, -9.81 * kStep * kStep, 0);
            before_[i] = old;
        }
    }

    void pull(size_t a, size_t b, double length, double stiffness) {
        const Double3 d = now_[b] - now_[a];
        const double size = glm::length(d);
        if (!(size > 0)) return;
        const Double3 shift = d * (stiffness * (size - length) / (2 * size));
        now_[a] += shift;
        now_[b] -= shift;
    }

    // Threads, diagonals and, more softly, what resists bending; back and forth in turn.
    void restore(int turn) {
        const auto visit = [&](int i, int j) {
            if (i + 1 < n_) pull(at(i, j), at(i + 1, j), rest_, 0.9);
            if (j + 1 < n_) pull(at(i, j), at(i, j + 1), rest_, 0.9);
            if (i + 1 < n_ && j + 1 < n_) {
                pull(at(i, j), at(i + 1, j + 1), rest_ * std::sqrt(2.0), 0.4);
                pull(at(i + 1, j), at(i, j + 1), rest_ * std::sqrt(2.0), 0.4);
            }
            if (i + 2 < n_) pull(at(i, j), at(i + 2, j), 2 * rest_, 0.15);
            if (j + 2 < n_) pull(at(i, j), at(i, j + 2), 2 * rest_, 0.15);
        };
        for (int k = 0; k < n_ * n_; ++k) {
            const int place = turn % 2 == 0 ? k : n_ * n_ - 1 - k;
            visit(place % n_, place / n_);
        }
    }

    void collide() {
        const Double3 center(0, kBall, 0);
        constexpr double kReach = kBall + 0.015;
        for (size_t i = 0; i < now_.size(); ++i) {
            Double3& p = now_[i];
            const Double3 offset = p - center;
            const double distance = glm::length(offset);
            if (distance < kReach && distance > 0) {
                p = center + offset * (kReach / distance);
                before_[i] = glm::mix(before_[i], p, 0.6);  // friction
            }
            if (p.y < kFloor) {
                p.y = kFloor;
                before_[i] = glm::mix(before_[i], p, 0.7);
            }
        }
    }

    int n_;
    double rest_;
    std::vector<Double3> now_, before_;
};

}  // namespace

Mesh make_cloth(ProceduralParameters& p) {
    const int detail = p.whole("detail", 96, 4, 192);
    const auto seed = static_cast<uint32_t>(p.whole("seed", 1, 0, 1'000'000));
    // A coarse one falls; finer ones start from it and have their folds to find.
    int levels = 0;
    while (detail >> levels > 40)
        ++levels;
    Sheet sheet((detail + (1 << levels) - 1) >> levels, seed);
    sheet.fall(300);
    for (int level = 0; level < levels; ++level) {
        sheet = sheet.refined();
        sheet.fall(level + 1 == levels ? 24 : 60);
    }
    return sheet.mesh();
}

}  // namespace tp
