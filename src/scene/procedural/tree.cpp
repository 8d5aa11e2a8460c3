#include "makers.h"
#include "surfaces.h"

#include <teapath/core/tea.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <functional>

namespace tp {
namespace {

constexpr double kPiDouble = 3.14159265358979323846;

// Numbers in [0, 1) of a branch, by its own counter.
class BranchNumbers {
public:
    BranchNumbers(uint32_t seed, uint32_t branch) : key_(tea_key(0, seed)), branch_(branch) {}
    double next() { return tea_encrypt<8>({branch_, count_++}, key_).v0 / 4294967296.0; }

private:
    TeaKey key_;
    uint32_t branch_, count_ = 0;
};

struct Branch {
    Double3 from{0, 0, 0};
    Double3 direction{0, 1, 0};
    double length = 0.34;
    double radius = 0.035;
    int level = 0;
    uint32_t number = 1;  // 1 is the trunk; a branch's children are 4 n, 4 n + 1, …
};

// The end of a branch that bends a little, as a Bezier curve.
struct Bend {
    std::vector<Double3> points;
    Double3 tip, direction;
};

Bend bend_of(const Branch& b, BranchNumbers& u) {
    const Double3 drift = Double3(u.next() - 0.5, 0.2 + 0.3 * u.next(), u.next() - 0.5) * 0.5;
    const Double3 end = glm::normalize(b.direction + drift);
    const double third = b.length / 3;
    const Double3 tip = b.from + (b.direction + end) * (b.length / 2);
    return {{b.from, b.from + b.direction * third, tip - end * third, tip}, tip, end};
}

// Calls `visit` with every branch and its bend.
void grow(const Branch& b, int levels, uint32_t seed,
          const std::function<void(const Branch&, const Bend&)>& visit) {
    BranchNumbers u(seed, b.number);
    const Bend bend = bend_of(b, u);
    visit(b, bend);
    if (b.level + 1 >= levels) return;
    const int children = b.level == 0 ? 4 : u.next() < 0.7 ? 3 : 2;
    const double first = u.next() * 2 * kPiDouble;
    for (int i = 0; i < children; ++i) {
        // Around the branch by the golden angle, the first one nearly straight on.
        const double around = first + i * 2.39996;
        const double away = (i == 0 ? 0.18 : 0.55) + 0.25 * u.next();
        const Double3 f = bend.direction;
        const Double3 aside = std::abs(f.y) < 0.9 ? Double3(0, 1, 0) : Double3(1, 0, 0);
        const Double3 x = glm::normalize(glm::cross(f, aside)), y = glm::cross(f, x);
        Branch child;
        child.from = i == 0 ? bend.tip : bezier(bend.points, 0.55 + 0.4 * u.next());
        child.direction = glm::normalize(
            f * std::cos(away) + (x * std::cos(around) + y * std::sin(around)) * std::sin(away));
        child.length = b.length * (0.68 + 0.16 * u.next());
        child.radius = b.radius * (i == 0 ? 0.72 : 0.55);
        child.level = b.level + 1;
        child.number = 4 * b.number + static_cast<uint32_t>(i);
        grow(child, levels, seed, visit);
    }
}

struct TreeParameters {
    uint32_t seed;
    int levels;
    explicit TreeParameters(ProceduralParameters& p)
        : seed(static_cast<uint32_t>(p.whole("seed", 1, 0, 1'000'000))),
          levels(p.whole("levels", 6, 1, 9)) {}
};

void add_leaf(Mesh& mesh, Double3 place, Double3 along, Double3 across, double size) {
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    const Double3 normal = glm::normalize(glm::cross(across, along));
    const Double3 corners[] = {place, place + along * (size * 0.5) + across * (size * 0.3),
                               place + along * size - normal * (size * 0.15),
                               place + along * (size * 0.5) - across * (size * 0.3)};
    const Float2 uvs[] = {{0.5, 1}, {1, 0.5}, {0.5, 0}, {0, 0.5}};
    for (int i = 0; i < 4; ++i) {
        mesh.positions.push_back(Float3(corners[i]));
        mesh.uvs[0].push_back(uvs[i]);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

}  // namespace

Mesh make_tree(ProceduralParameters& p) {
    const TreeParameters tree(p);
    Mesh mesh;
    grow({}, tree.levels, tree.seed, [&](const Branch& b, const Bend& bend) {
        const int around = std::max(14 - 2 * b.level, 4), along = std::max(6 - b.level, 2);
        const double taper = b.level == 0 ? 0.9 : 0.3;
        add_tube(
            mesh, around, along, [&](double t) { return bezier(bend.points, t); },
            [&](double t) { return b.radius * (1 - 0.3 * t) * (1 + taper * std::exp(-9 * t)); },
            false);
    });
    return mesh;
}

Mesh make_leaves(ProceduralParameters& p) {
    const TreeParameters tree(p);
    const double size = p.number("size", 0.06, 1e-3, 1);
    Mesh mesh;
    mesh.uvs.emplace_back();
    grow({}, tree.levels, tree.seed, [&](const Branch& b, const Bend& bend) {
        if (b.level + 2 < tree.levels) return;
        BranchNumbers u(tree.seed + 7919, b.number);
        for (int i = 0; i < 6; ++i) {
            const Double3 along = glm::normalize(
                bend.direction + Double3(u.next() - 0.5, u.next() - 0.7, u.next() - 0.5) * 2.5);
            const Double3 any(u.next() - 0.5, u.next() - 0.5, u.next() - 0.5);
            Double3 across = glm::cross(along, any);
            if (!(glm::length(across) > 1e-6)) continue;
            across = glm::normalize(across);
            add_leaf(mesh, bezier(bend.points, 0.3 + 0.7 * u.next()), along, across,
                     size * (0.7 + 0.6 * u.next()));
        }
    });
    return mesh;
}

}  // namespace tp
