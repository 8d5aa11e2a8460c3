// The tree over hittables: structure, bounds and agreement with brute force.
#include "support/backend_option.h"

#include <teapath/core/parallel.h>
#include <teapath/core/tea.h>
#include <teapath/device/bvh_build.h>
#include <teapath/kernel/traverse.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>

using namespace tp;
using namespace tp::test;

namespace {

std::vector<Hittable> random_spheres(size_t count, unsigned seed, Real radius) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<Real> place(-10, 10), size(radius / 4, radius);
    std::vector<Hittable> hittables(count);
    for (Hittable& h : hittables) {
        h.sphere = {{place(random), place(random), place(random)}, size(random)};
        h.object = static_cast<uint32_t>(&h - hittables.data()) + 1;
    }
    return hittables;
}

// Shapes of all kinds, some of them flat and axis-aligned.
std::vector<Hittable> random_shapes(size_t count, unsigned seed) {
    std::vector<Hittable> hittables = random_spheres(count, seed, 1);
    std::mt19937 random(seed + 1);
    std::uniform_real_distribution<Real> edge(-1, 1);
    for (size_t i = 0; i < count; ++i) {
        Hittable& h = hittables[i];
        const Vec3 center = h.sphere.center;
        Flat flat{center,
                  {edge(random), edge(random), edge(random)},
                  {edge(random), edge(random), edge(random)}};
        switch (i % 6) {
            case 0: break;
            case 1:
                h.kind = HittableKind::Rectangle;
                h.rectangle = Rectangle{{center, {1, 0, 0}, {0, 0, 1}}};
                break;
            case 2: h.kind = HittableKind::Triangle, h.triangle = Triangle{flat}; break;
            case 3: h.kind = HittableKind::Disk, h.disk = Disk{flat}; break;
            case 4: h.kind = HittableKind::Box, h.box = Box{{center, Mat3(Real(2))}}; break;
            default:
                h.kind = HittableKind::Ellipsoid,
                h.ellipsoid = Ellipsoid{
                    {center, glm::inverse(Mat3(1, 0, 0, 0, Real(0.3), 0, Real(0.2), 0, 2))}};
        }
    }
    return hittables;
}

// Rectangles across the axes, whose boxes are flat; many share a plane, many an edge.
std::vector<Hittable> flat_boxes(size_t count) {
    std::vector<Hittable> hittables = random_spheres(count, 4, 1);
    std::mt19937 random(4);
    std::uniform_int_distribution<int> cell(-8, 8);
    for (size_t i = 0; i < count; ++i) {
        const auto axis = static_cast<int>(i % 3);
        Vec3 corner(0), u(0), v(0);
        for (int a = 0; a < 3; ++a)
            corner[a] = static_cast<Real>(cell(random));
        u[(axis + 1) % 3] = 1;
        v[(axis + 2) % 3] = 1;
        hittables[i].kind = HittableKind::Rectangle;
        hittables[i].rectangle = Rectangle{{corner, u, v}};
    }
    return hittables;
}

struct Built {
    std::vector<Hittable> hittables;  // in leaf order
    BvhTree tree;
    SceneView view() const {
        SceneView v;
        v.hittables = make_span(hittables);
        v.nodes = make_span(tree.nodes);
        return v;
    }
};

Built build(const std::vector<Hittable>& hittables) {
    std::vector<Bounds> boxes;
    for (const Hittable& h : hittables) {
        const Bounds b = bounds_of(h);
        const Vec3 pad = max(abs(b.low), abs(b.high)) * (8 * kEpsilon);
        boxes.push_back({b.low - pad, b.high + pad});
    }
    Built built;
    built.tree = build_bvh(boxes);
    for (const uint32_t i : built.tree.order)
        built.hittables.push_back(hittables[i]);
    return built;
}

// Walks the tree: each leaf position once, parents contain children. Returns the leaves' count.
size_t walk(const Built& built, uint32_t code, const Bounds& box, int depth,
            std::vector<int>& visits) {
    CHECK(depth <= kMaxTreeDepth);
    if (code & kLeafBit) {
        const uint32_t first = (code & ~kLeafBit) >> kLeafCountBits,
                       count = (code & (kMaxLeafSize - 1)) + 1;
        for (uint32_t i = first; i < first + count; ++i) {
            ++visits[i];
            const Bounds b = bounds_of(built.hittables[i]);
            CHECK(join(box, b).low == box.low);
            CHECK(join(box, b).high == box.high);
        }
        return 1;
    }
    const BvhNode& n = built.tree.nodes[code];
    const Bounds a{{n.x.x, n.y.x, n.z.x}, {n.x.y, n.y.y, n.z.y}},
        b{{n.x.z, n.y.z, n.z.z}, {n.x.w, n.y.w, n.z.w}};
    CHECK(join(box, a).low == box.low);
    CHECK(join(box, a).high == box.high);
    const size_t left = walk(built, n.child[0], a, depth + 1, visits);
    if (b.is_empty()) return left;  // the root of a single leaf
    CHECK(join(box, b).low == box.low);
    CHECK(join(box, b).high == box.high);
    return left + walk(built, n.child[1], b, depth + 1, visits);
}

void check_structure(const Built& built) {
    std::vector<int> visits(built.hittables.size(), 0);
    const size_t leaves = walk(built, 0, built.tree.bounds, 0, visits);
    CHECK(std::all_of(visits.begin(), visits.end(), [](int n) { return n == 1; }));
    CHECK(leaves == static_cast<size_t>(built.tree.stats.leaf_count));
    // A binary tree of n leaves has n - 1 inner nodes; a single leaf hangs from a root of its own.
    CHECK(built.tree.nodes.size() == std::max<size_t>(leaves - 1, 1));
    CHECK(built.tree.stats.depth <= kMaxTreeDepth);
}

// A ray's number decides where it goes: every fourth lies across an axis, every eighth along one;
// with `on_grid` many start on whole numbers.
void make_ray(const TeaKey& key, int i, bool on_grid, Vec3& origin, Vec3& direction) {
    Real r[6];
    for (uint32_t j = 0; j < 3; ++j) {
        const TeaBlock block = tea_encrypt<8>({static_cast<uint32_t>(i), j}, key);
        r[2 * j] = unit_real(block.v0);
        r[2 * j + 1] = unit_real(block.v1);
    }
    origin = Vec3(r[0], r[1], r[2]) * Real(30) - Vec3(15);
    if (on_grid && i % 2 == 0)
        for (int a = 0; a < 3; ++a)
            origin[a] = std::round(origin[a]);
    direction = Vec3(r[3], r[4], r[5]) * Real(2) - Vec3(1);
    if (i % 4 == 0) direction[i / 4 % 3] = 0;
    if (i % 8 == 0) direction[(i / 4 + 1) % 3] = 0;
    if (is_black(direction)) direction.x = 1;
    direction = normalize(direction);
}

// The tree and brute force find the same distance and object. Where two objects are met at exactly
// the same distance, either will do.
template <uint32_t kFeatures = kFeatureAll>
void check_rays(const Built& built, int rays, unsigned seed, bool on_grid = false) {
    const TeaKey key = tea_key(0, seed);
    SceneView tree = built.view(), brute = built.view();
    brute.nodes = {};  // without a tree every hittable is visited
    std::atomic<int> hits = 0, wrong_distance = 0, wrong_object = 0, wrong_shadow = 0;
    parallel_for(rays, 100, [&](int64_t first, int64_t last) {
        for (auto i = static_cast<int>(first); i < last; ++i) {
            Vec3 o, d;
            make_ray(key, i, on_grid, o, d);
            const Hit a = intersect_scene<kFeatures>(tree, o, d, kInfinity);
            const Hit b = intersect_scene<kFeatures>(brute, o, d, kInfinity);
            const bool met = b.index != kNoHit;
            hits += met;
            wrong_distance += a.t != b.t;
            wrong_shadow += is_blocked<kFeatures>(tree, o, d, kInfinity, {}) != met;
            if (a.index == b.index) continue;
            Hit again;
            wrong_object += !met || a.index == kNoHit ||
                            !intersect(built.hittables[a.index], o, d, kInfinity, again) ||
                            again.t != b.t;
        }
    });
    CHECK(wrong_distance == 0);
    CHECK(wrong_object == 0);
    CHECK(wrong_shadow == 0);
    if (built.hittables.size() > 50) CHECK(hits > rays / 50);
}

}  // namespace

TEST_CASE("AC-B1: the tree finds what brute force finds") {
    for (const size_t count : {0u, 1u, 2u, 3u, 100u}) {
        CAPTURE(count);
        const Built built = build(random_shapes(count, 5));
        if (count > 0) check_structure(built);
        check_rays(built, 1000000, static_cast<unsigned>(count));
    }
    // Brute force takes its time: a million rays only in a long run.
    const Built large = build(random_shapes(10000, 3));
    check_structure(large);
    check_rays(large, long_run() ? 1000000 : 20000, 1);
}

TEST_CASE("AC-B1: a thousand rays against a million spheres") {
    const Built built = build(random_spheres(1000000, 6, Real(0.1)));
    check_structure(built);
    check_rays<0>(built, 1000, 8);
}

TEST_CASE("AC-B1: flat boxes, with rays in their planes and along their edges") {
    const Built built = build(flat_boxes(3000));
    check_structure(built);
    check_rays(built, 20000, 5, true);
}

TEST_CASE("AC-B1: duplicates, and a hundred thousand coincident spheres") {
    std::vector<Hittable> twins = random_spheres(500, 1, 2);
    twins.insert(twins.end(), twins.begin(), twins.end());
    const Built doubled = build(twins);
    check_structure(doubled);
    check_rays(doubled, 20000, 2);

    std::vector<Hittable> same(100000);
    for (Hittable& h : same)
        h.sphere = {{1, 2, 3}, 1};
    const Built coincident = build(same);
    CHECK(coincident.tree.stats.depth <= kMaxTreeDepth);
    const Hit hit =
        intersect_scene<kFeatureAll>(coincident.view(), {1, 2, 10}, {0, 0, -1}, kInfinity);
    CHECK(hit.t == doctest::Approx(6));
}

TEST_CASE("AC-B2: a chain that would make the tree deep stays within the bound") {
    // Sizes that double: the heuristic splits one off at a time.
    std::vector<Hittable> chain(120);
    double x = 0, size = 1e-15;
    for (Hittable& h : chain) {
        h.sphere = {{static_cast<Real>(x), 0, 0}, static_cast<Real>(size / 4)};
        x += size;
        size *= 1.6;
    }
    const Built built = build(chain);
    CHECK(built.tree.stats.depth <= kMaxTreeDepth);
    check_structure(built);
}

TEST_CASE("the tree is the same whatever the number of threads, and large builds are right") {
    const std::vector<Hittable> hittables = random_spheres(60000, 9, Real(0.1));
    const Built a = build(hittables), b = build(hittables);
    CHECK(a.tree.order == b.tree.order);
    check_structure(a);
    check_rays(a, 300, 3);
}
