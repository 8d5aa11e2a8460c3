#include "light_tree_build.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

namespace tp {
namespace {

constexpr int kBins = 12;
constexpr double kPiDouble = 3.14159265358979323846;

// A cone of directions.
struct Cone {
    Vec3 axis{0, 0, 1};
    double spread = -1;  // half angle, 0 to pi; negative: empty
};

double angle_of_cosine(double cosine) {
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}

// The smallest cone around both.
Cone join(const Cone& a, const Cone& b) {
    if (a.spread < 0) return b;
    if (b.spread < 0) return a;
    const Cone &wide = a.spread >= b.spread ? a : b, &narrow = a.spread >= b.spread ? b : a;
    const double between = angle_of_cosine(static_cast<double>(dot(wide.axis, narrow.axis)));
    if (std::min(between + narrow.spread, kPiDouble) <= wide.spread) return wide;
    const double spread = (wide.spread + between + narrow.spread) / 2;
    if (spread >= kPiDouble) return {wide.axis, kPiDouble};
    const Vec3 side = cross(wide.axis, narrow.axis);
    const Real length2 = length_squared(side);
    if (!(length2 > 0)) return {wide.axis, kPiDouble};
    // Turns the wide one's axis towards the narrow one's.
    const double turn = spread - wide.spread;
    const Vec3 across = cross(side * (1 / tp::sqrt(length2)), wide.axis);
    return {normalize(wide.axis * static_cast<Real>(std::cos(turn)) +
                      across * static_cast<Real>(std::sin(turn))),
            spread};
}

// What is known of a set of emitters.
struct Extent {
    Bounds box;
    Cone cone;
    double power = 0;
    Real cos_reach = 1;
    bool two_sided = false;

    void add(const Extent& e) {
        box = tp::join(box, e.box);
        cone = join(cone, e.cone);
        power += e.power;
        cos_reach = min(cos_reach, e.cos_reach);
        two_sided = two_sided || e.two_sided;
    }
};

Extent extent_of(const EmitterBounds& e) {
    return {e.box,
            {e.axis, angle_of_cosine(static_cast<double>(e.cos_spread))},
            e.power,
            e.cos_reach,
            e.two_sided};
}

// The measure of the directions that lights with such normals shine in, each into a half space.
double measure_of(const Cone& cone) {
    const double spread = std::max(cone.spread, 0.0);
    const double reach = std::min(spread + kPiDouble / 2, kPiDouble);
    return 2 * kPiDouble * (1 - std::cos(spread)) +
           kPiDouble / 2 *
               (2 * reach * std::sin(spread) - std::cos(spread - 2 * reach) -
                2 * spread * std::sin(spread) + std::cos(spread));
}

double cost_of(const Extent& e) {
    if (e.box.is_empty()) return 0;
    return e.power * measure_of(e.cone) * static_cast<double>(half_area(e.box));
}

class Builder {
public:
    Builder(const std::vector<EmitterBounds>& emitters, LightTree& tree)
        : emitters_(emitters), tree_(tree), order_(emitters.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        tree_.trails.resize(emitters.size());
        tree_.nodes.reserve(2 * emitters.size());
    }

    void build() {
        if (!order_.empty()) add_node(0, order_.size(), 0, 0);
    }

private:
    Extent extent_of_range(size_t first, size_t last) const {
        Extent e;
        for (size_t i = first; i < last; ++i)
            e.add(extent_of(emitters_[order_[i]]));
        return e;
    }

    void add_node(size_t first, size_t last, uint32_t trail, uint32_t depth) {
        const Extent e = extent_of_range(first, last);
        const size_t index = tree_.nodes.size();
        tree_.nodes.push_back({e.box.low, e.box.high, e.cone.axis,
                               static_cast<Real>(std::cos(e.cone.spread)), e.cos_reach,
                               static_cast<Real>(e.power), 0, 0, e.two_sided});
        if (last - first == 1) {
            tree_.nodes[index].is_leaf = 1;
            tree_.nodes[index].next = order_[first];
            tree_.trails[order_[first]] = trail;
            return;
        }
        const size_t middle = split(first, last, e, depth);
        add_node(first, middle, trail, depth + 1);
        tree_.nodes[index].next = static_cast<uint32_t>(tree_.nodes.size());
        add_node(middle, last, trail | 1u << depth, depth + 1);
    }

    // Puts the emitters of the first child before those of the second.
    size_t split(size_t first, size_t last, const Extent& all, uint32_t depth) {
        Bounds centers;
        for (size_t i = first; i < last; ++i)
            centers = tp::join(centers, emitters_[order_[i]].box.center());
        const auto levels = static_cast<uint32_t>(std::bit_width(last - first - 1));
        const bool in_halves = depth + levels >= kMaxLightTreeDepth;
        double least = std::numeric_limits<double>::infinity();
        int best_axis = -1, best_bin = 0;
        for (int axis = 0; axis < 3 && !in_halves; ++axis)
            try_axis(first, last, all, centers, axis, least, best_axis, best_bin);
        if (best_axis < 0) return halves(first, last, centers);
        const auto middle =
            std::partition(order_.begin() + static_cast<ptrdiff_t>(first),
                           order_.begin() + static_cast<ptrdiff_t>(last),
                           [&](uint32_t i) { return bin_of(i, centers, best_axis) <= best_bin; });
        return static_cast<size_t>(middle - order_.begin());
    }

    int bin_of(uint32_t emitter, const Bounds& centers, int axis) const {
        const Real place = emitters_[emitter].box.center()[axis] - centers.low[axis];
        return std::clamp(static_cast<int>(place / centers.extent()[axis] * kBins), 0, kBins - 1);
    }

    void try_axis(size_t first, size_t last, const Extent& all, const Bounds& centers, int axis,
                  double& least, int& best_axis, int& best_bin) const {
        const Real length = centers.extent()[axis];
        if (!(length > 0)) return;
        std::array<Extent, kBins> bins;
        std::array<size_t, kBins> counts{};
        for (size_t i = first; i < last; ++i) {
            const auto bin = static_cast<size_t>(bin_of(order_[i], centers, axis));
            bins[bin].add(extent_of(emitters_[order_[i]]));
            ++counts[bin];
        }
        // Long and thin ones are split across.
        const double regularizer = static_cast<double>(max_component(all.box.extent())) /
                                   std::max(static_cast<double>(all.box.extent()[axis]), 1e-30);
        std::array<double, kBins> below{};
        Extent e;
        for (size_t b = 0; b + 1 < kBins; ++b) {
            e.add(bins[b]);
            below[b] = cost_of(e);
        }
        e = {};
        size_t above = 0;
        for (size_t b = kBins - 1; b-- > 0;) {
            e.add(bins[b + 1]);
            above += counts[b + 1];
            if (above == 0 || above == last - first) continue;
            const double cost = regularizer * (below[b] + cost_of(e));
            if (!(cost < least)) continue;
            least = cost;
            best_axis = axis;
            best_bin = static_cast<int>(b);
        }
    }

    size_t halves(size_t first, size_t last, const Bounds& centers) {
        const Vec3 size = centers.extent();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const size_t middle = first + (last - first) / 2;
        const auto at = [&](size_t i) { return order_.begin() + static_cast<ptrdiff_t>(i); };
        std::nth_element(at(first), at(middle), at(last), [&](uint32_t a, uint32_t b) {
            return emitters_[a].box.center()[axis] < emitters_[b].box.center()[axis];
        });
        return middle;
    }

    const std::vector<EmitterBounds>& emitters_;
    LightTree& tree_;
    std::vector<uint32_t> order_;
};

}  // namespace

LightTree build_light_tree(const std::vector<EmitterBounds>& emitters) {
    LightTree tree;
    Builder(emitters, tree).build();
    return tree;
}

}  // namespace tp
