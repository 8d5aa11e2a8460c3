// Gradient noise whose gradients come from TEA: Perlin, "Improving Noise", 2002, with the cell's
// coordinates encrypted in place of a table of permutations.
#pragma once

#include <teapath/core/math.h>
#include <teapath/core/tea.h>

#include <cmath>

namespace tp {

class Noise2d {
public:
    explicit Noise2d(uint32_t seed) : key_(tea_key(0, seed)) {}

    /// About -1 to 1, 0 at whole coordinates, with a continuous curvature.
    double operator()(Double2 p) const {
        const Double2 cell = glm::floor(p), f = p - cell;
        const auto corner = [&](int i, int j) {
            const TeaBlock block{static_cast<uint32_t>(static_cast<int>(cell.x) + i),
                                 static_cast<uint32_t>(static_cast<int>(cell.y) + j)};
            const double angle =
                tea_encrypt<6>(block, key_).v0 * (2 * 3.14159265358979323846 / 4294967296.0);
            return std::cos(angle) * (f.x - i) + std::sin(angle) * (f.y - j);
        };
        const Double2 w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
        return 1.4 * glm::mix(glm::mix(corner(0, 0), corner(1, 0), w.x),
                              glm::mix(corner(0, 1), corner(1, 1), w.x), w.y);
    }

private:
    TeaKey key_;
};

}  // namespace tp
