#include <teapath/core/parallel.h>
#include <teapath/device/bvh_build.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <numeric>

namespace tp {
namespace {

// A primitive on its way into the tree.
struct Item {
    Bounds box;
    Vec3 center;
    uint32_t index;
};

// Items [first, last) that are to become one child, `depth` levels below the root.
struct Range {
    uint32_t first, last;
    int depth;
    uint32_t size() const { return last - first; }
};

struct Split {
    uint32_t middle;  // first item of the right side
    bool is_leaf;
};

constexpr int kMaxBins = 64;

struct Bin {
    Bounds box;
    uint32_t count = 0;
};

// Levels of nodes that a balanced tree over `count` items needs at least.
int levels_needed(uint32_t count, uint32_t leaf_size) {
    const uint32_t leaves = (count + leaf_size - 1) / leaf_size;
    return static_cast<int>(std::bit_width(leaves - 1));
}

class Builder {
public:
    Builder(std::vector<Item>& items, const BvhConfig& config) : items_(items), config_(config) {
        config_.bins = std::clamp(config_.bins, 2, kMaxBins);
        config_.leaf_size = std::clamp<uint32_t>(config_.leaf_size, 1, kMaxLeafSize);
    }

    // Appends the subtree of `range` to `nodes` and returns its child code.
    uint32_t build(const Range& range, std::vector<BvhNode>& nodes, BvhStats& stats) {
        const Split split = find_split(range);
        if (split.is_leaf) {
            ++stats.leaf_count;
            return kLeafBit | range.first << kLeafCountBits | (range.size() - 1);
        }
        const auto index = static_cast<uint32_t>(nodes.size());
        nodes.emplace_back();
        stats.depth = std::max(stats.depth, range.depth + 1);
        const Range left{range.first, split.middle, range.depth + 1};
        const Range right{split.middle, range.last, range.depth + 1};
        const uint32_t left_code = build(left, nodes, stats);
        const uint32_t right_code = build(right, nodes, stats);
        nodes[index] = make_node(box_of(left), left_code, box_of(right), right_code);
        return index;
    }

    Bounds box_of(const Range& range) const {
        Bounds box;
        for (uint32_t i = range.first; i < range.last; ++i)
            box = join(box, items_[i].box);
        return box;
    }

    static BvhNode make_node(const Bounds& a, uint32_t code_a, const Bounds& b, uint32_t code_b) {
        return {{a.low.x, a.high.x, b.low.x, b.high.x},
                {a.low.y, a.high.y, b.low.y, b.high.y},
                {a.low.z, a.high.z, b.low.z, b.high.z},
                {code_a, code_b},
                {0, 0}};
    }

    Split find_split(const Range& range) {
        const uint32_t count = range.size();
        if (count == 1) return {0, true};

        // Where the depth runs out, only halving keeps the bound.
        const int levels_left = config_.max_depth - range.depth;
        if (count > 1 && levels_needed(count, config_.leaf_size) >= levels_left)
            return count <= config_.leaf_size ? Split{0, true} : median_split(range);

        Bounds centers, box;
        for (uint32_t i = range.first; i < range.last; ++i) {
            centers = join(centers, items_[i].center);
            box = join(box, items_[i].box);
        }
        const Vec3 extent = centers.extent();
        if (max_component(extent) <= 0)
            return count <= config_.leaf_size ? Split{0, true} : median_split(range);

        // The cheapest of the planes between bins, over the three axes.
        double best_cost = std::numeric_limits<double>::infinity();
        int best_axis = 0, best_bin = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (extent[axis] > 0) scan_axis(range, axis, centers, best_cost, best_axis, best_bin);
        }
        const double area = static_cast<double>(half_area(box));
        const double split_cost =
            config_.node_cost + config_.leaf_cost * best_cost / std::max(area, 1e-300);
        if (count <= config_.leaf_size && config_.leaf_cost * count <= split_cost) return {0, true};

        const Real low = centers.low[best_axis], scale = bin_scale(extent[best_axis]);
        const auto middle = std::partition(
            items_.begin() + range.first, items_.begin() + range.last, [&](const Item& item) {
                return bin_of(item.center[best_axis], low, scale) <= best_bin;
            });
        const auto split = static_cast<uint32_t>(middle - items_.begin());
        if (split == range.first || split == range.last) return median_split(range);
        const uint32_t larger = std::max(split - range.first, range.last - split);
        if (levels_needed(larger, config_.leaf_size) > levels_left - 1) return median_split(range);
        return {split, false};
    }

private:
    Real bin_scale(Real extent) const {
        return static_cast<Real>(config_.bins) * (1 - 4 * kEpsilon) / extent;
    }

    int bin_of(Real center, Real low, Real scale) const {
        // Any number, also none at all: centres may be a denormal number apart.
        const Real bin = (center - low) * scale;
        if (!(bin > 0)) return 0;
        return bin < static_cast<Real>(config_.bins) ? static_cast<int>(bin) : config_.bins - 1;
    }

    void scan_axis(const Range& range, int axis, const Bounds& centers, double& best_cost,
                   int& best_axis, int& best_bin) const {
        std::array<Bin, kMaxBins> bins;
        const Real low = centers.low[axis], scale = bin_scale(centers.extent()[axis]);
        for (uint32_t i = range.first; i < range.last; ++i) {
            Bin& bin = bins[static_cast<size_t>(bin_of(items_[i].center[axis], low, scale))];
            bin.box = join(bin.box, items_[i].box);
            ++bin.count;
        }
        std::array<double, kMaxBins> right_cost;
        Bounds box;
        uint32_t count = 0;
        for (int i = config_.bins - 1; i > 0; --i) {
            box = join(box, bins[static_cast<size_t>(i)].box);
            count += bins[static_cast<size_t>(i)].count;
            right_cost[static_cast<size_t>(i)] = static_cast<double>(half_area(box)) * count;
        }
        box = Bounds{};
        count = 0;
        for (int i = 0; i + 1 < config_.bins; ++i) {
            box = join(box, bins[static_cast<size_t>(i)].box);
            count += bins[static_cast<size_t>(i)].count;
            if (count == 0 || count == range.size()) continue;
            const double cost = static_cast<double>(half_area(box)) * count +
                                right_cost[static_cast<size_t>(i) + 1];
            if (cost < best_cost) {
                best_cost = cost;
                best_axis = axis;
                best_bin = i;
            }
        }
    }

    Split median_split(const Range& range) {
        Bounds centers;
        for (uint32_t i = range.first; i < range.last; ++i)
            centers = join(centers, items_[i].center);
        const Vec3 e = centers.extent();
        const int axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
        const uint32_t middle = range.first + range.size() / 2;
        std::nth_element(items_.begin() + range.first, items_.begin() + middle,
                         items_.begin() + range.last, [axis](const Item& a, const Item& b) {
                             return a.center[axis] != b.center[axis]
                                        ? a.center[axis] < b.center[axis]
                                        : a.index < b.index;
                         });
        return {middle, false};
    }

    std::vector<Item>& items_;
    BvhConfig config_;
};

// A child of the top of the tree whose subtree is built on its own.
struct Subtree {
    Range range;
    uint32_t parent;  // node whose child it is
    int side;
    std::vector<BvhNode> nodes;
    uint32_t code = 0;
    BvhStats stats;
};

constexpr uint32_t kSubtreeSize = 8192;

// Splits from the root down to ranges of kSubtreeSize, which `subtrees` collects.
void build_top(Builder& builder, const Range& range, uint32_t parent, int side,
               std::vector<BvhNode>& nodes, std::vector<Subtree>& subtrees) {
    if (range.size() <= kSubtreeSize) {
        subtrees.push_back({range, parent, side, {}, 0, {}});
        return;
    }
    const Split split = builder.find_split(range);
    const auto index = static_cast<uint32_t>(nodes.size());
    const Range left{range.first, split.middle, range.depth + 1};
    const Range right{split.middle, range.last, range.depth + 1};
    nodes.push_back(Builder::make_node(builder.box_of(left), 0, builder.box_of(right), 0));
    if (index > 0) nodes[parent].child[side] = index;
    build_top(builder, left, index, 0, nodes, subtrees);
    build_top(builder, right, index, 1, nodes, subtrees);
}

// Appends a subtree's nodes, whose indices start at 0, to the whole.
void append(std::vector<BvhNode>& nodes, const Subtree& subtree) {
    const auto base = static_cast<uint32_t>(nodes.size());
    for (BvhNode node : subtree.nodes) {
        for (uint32_t& child : node.child)
            if (!(child & kLeafBit)) child += base;
        nodes.push_back(node);
    }
    nodes[subtree.parent].child[subtree.side] =
        subtree.code & kLeafBit ? subtree.code : subtree.code + base;
}

// A tree of one leaf: the root's other child is empty and never met.
BvhNode root_of_leaf(const Bounds& box, uint32_t code) {
    return Builder::make_node(box, code, Bounds{}, code);
}

double sah_cost(const std::vector<BvhNode>& nodes, const Bounds& bounds, const BvhConfig& config) {
    const double root_area = static_cast<double>(half_area(bounds));
    if (!(root_area > 0)) return 0;
    double cost = config.node_cost;
    for (const BvhNode& n : nodes) {
        const std::array<Bounds, 2> boxes = {Bounds{{n.x.x, n.y.x, n.z.x}, {n.x.y, n.y.y, n.z.y}},
                                             Bounds{{n.x.z, n.y.z, n.z.z}, {n.x.w, n.y.w, n.z.w}}};
        for (size_t i = 0; i < 2; ++i) {
            const double share = static_cast<double>(half_area(boxes[i])) / root_area;
            const uint32_t code = n.child[i];
            cost += share * (code & kLeafBit ? config.leaf_cost * ((code & (kMaxLeafSize - 1)) + 1)
                                             : config.node_cost);
        }
    }
    return cost;
}

}  // namespace

BvhTree build_bvh(const std::vector<Bounds>& boxes, const BvhConfig& config) {
    const auto start = std::chrono::steady_clock::now();
    BvhTree tree;
    if (boxes.empty()) return tree;
    std::vector<Item> items(boxes.size());
    parallel_for(static_cast<int64_t>(boxes.size()), 16384, [&](int64_t first, int64_t last) {
        for (auto i = static_cast<size_t>(first); i < static_cast<size_t>(last); ++i)
            items[i] = {boxes[i], boxes[i].center(), static_cast<uint32_t>(i)};
    });
    Builder builder(items, config);
    const Range all{0, static_cast<uint32_t>(boxes.size()), 0};
    tree.bounds = builder.box_of(all);

    if (all.size() <= kSubtreeSize) {
        const uint32_t code = builder.build(all, tree.nodes, tree.stats);
        if (code & kLeafBit) {
            tree.nodes.push_back(root_of_leaf(tree.bounds, code));
            tree.stats.depth = 1;
        }
    } else {
        std::vector<Subtree> subtrees;
        build_top(builder, all, 0, 0, tree.nodes, subtrees);
        shared_pool().for_each(static_cast<int64_t>(subtrees.size()), [&](int64_t i) {
            Subtree& s = subtrees[static_cast<size_t>(i)];
            s.code = builder.build(s.range, s.nodes, s.stats);
        });
        for (const Subtree& s : subtrees) {
            append(tree.nodes, s);
            tree.stats.depth = std::max({tree.stats.depth, s.stats.depth, s.range.depth});
            tree.stats.leaf_count += s.stats.leaf_count;
        }
    }

    tree.order.resize(items.size());
    for (size_t i = 0; i < items.size(); ++i)
        tree.order[i] = items[i].index;
    tree.stats.sah_cost = sah_cost(tree.nodes, tree.bounds, config);
    tree.stats.build_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return tree;
}

}  // namespace tp
