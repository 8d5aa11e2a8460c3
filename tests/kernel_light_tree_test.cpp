// Which light is picked: picks follow the probabilities that the tree tells, no light that shines
// on a point is forgotten there, and pictures of many lights have less noise for it.
#include "support/chi2.h"
#include "support/hittables.h"
#include "support/scene_maker.h"

#include <teapath/device/host_view.h>
#include <teapath/device/light_build.h>
#include <teapath/kernel/light.h>

#include <cmath>
#include <random>

using namespace tp;
using namespace tp::test;

namespace {

// Lights of every kind, size and power in the cube [0, 10]^3.
struct Lights {
    SceneArrays arrays;
    std::vector<MeshView> meshes;
    SceneView view;

    explicit Lights(int count, double spread = 10) {
        std::mt19937 random(static_cast<uint32_t>(count));
        std::uniform_real_distribution<float> u(0, 1);
        for (int i = 0; i < count; ++i) {
            const Vec3 place = Vec3(u(random), u(random), u(random)) * static_cast<Real>(spread);
            const Vec3 a = Vec3(u(random), u(random), u(random)) - Vec3(Real(0.5));
            const Vec3 b = Vec3(u(random), u(random), u(random)) - Vec3(Real(0.5));
            Hittable h = i % 3 == 0
                             ? sphere(place, Real(0.05) + Real(0.2) * u(random))
                             : flat(i % 3 == 1 ? HittableKind::Rectangle : HittableKind::Triangle,
                                    place, a, b);
            h.inside_out = i % 5 == 0;
            h.material = static_cast<uint32_t>(i);
            arrays.hittables.push_back(h);
            MaterialRecord m;
            m.emits = 1;
            m.side = i % 7 == 0 ? EmissionSide::Both : EmissionSide::Outside;
            // One of them is black, one outshines all others.
            m.emission.color = Vec3(i == 3 ? Real(0) : i == 5 ? Real(1000) : u(random));
            arrays.materials.push_back(m);
        }
        build_lights(arrays);
        view = host_view(arrays, meshes);
    }
};

}  // namespace

TEST_CASE("light tree: picks follow the probabilities that it tells") {
    for (const int count : {1, 2, 7, 100, 1000}) {
        CAPTURE(count);
        const Lights lights(count);
        REQUIRE(lights.arrays.lights.size() == static_cast<size_t>(count));
        for (const Vec3& from : {Vec3(5, 5, 5), Vec3(-3, 2, 1), Vec3(1, 9, 4)}) {
            const Vec3 normal = normalize(Vec3(1, Real(0.4), Real(-0.2)));
            constexpr uint32_t kDraws = 200000;
            std::vector<double> observed(lights.arrays.lights.size()), expected;
            double sum = 0;
            for (uint32_t i = 0; i < lights.view.lights.size; ++i) {
                const Real p = light_probability(lights.view, LightRule::Tree, i, from, normal);
                expected.push_back(static_cast<double>(p) * kDraws);
                sum += static_cast<double>(p);
            }
            // What is left leads to lights that all face away.
            CHECK(sum < 1 + 1e-4);
            expected.push_back(std::max(1 - sum, 0.0) * kDraws);
            observed.push_back(0);
            const TeaKey key = tea_key(0, 9);
            int wrong = 0;
            for (uint32_t i = 0; i < kDraws; ++i) {
                const LightChoice choice = pick_light(lights.view, LightRule::Tree, from, normal,
                                                      unit_real(tea_encrypt<8>({i, 0}, key).v0));
                if (!(choice.probability > 0)) {
                    ++observed.back();
                    continue;
                }
                ++observed[choice.light];
                const double told = expected[choice.light] / kDraws;
                wrong += std::abs(static_cast<double>(choice.probability) - told) > 1e-4 * told;
            }
            CHECK(wrong == 0);
            const Chi2 chi2 = chi2_test(observed, expected);
            CHECK((count == 1 || chi2.p_value > 1e-4));
            CHECK(chi2.impossible < 10);  // of the rest, where its share is rounding
        }
    }
}

TEST_CASE("light tree: a light that shines on a point is never forgotten there") {
    for (const int count : {2, 30, 300}) {
        const Lights lights(count);
        std::mt19937 random(7);
        std::uniform_real_distribution<float> u(-1, 1), unit(0, 1);
        int forgotten = 0, lit = 0;
        for (int i = 0; i < 20000; ++i) {
            const Vec3 from = Vec3(5, 5, 5) + Vec3(u(random), u(random), u(random)) * Real(7);
            const Vec3 normal = normalize(Vec3(u(random), u(random), u(random)));
            const auto which = static_cast<uint32_t>(random() % lights.view.lights.size);
            const LightRecord& light = lights.view.lights[which];
            const Hittable& h = lights.view.hittables[light.hittable];
            const MaterialRecord& m = lights.view.materials[h.material];
            const ShapeSample s =
                sample_emitter<kFeatureAll>(lights.view, light, from, {unit(random), unit(random)});
            const bool front = dot(s.direction, s.point.normal) < 0;
            const bool shines = s.pdf > 0 && emits_towards(m, is_turned_inwards(h), front) &&
                                !is_black(m.emission.color) &&
                                abs(dot(s.direction, normal)) > Real(1e-3);
            lit += shines;
            forgotten += shines && !(light_probability(lights.view, LightRule::Tree, which, from,
                                                       normal) > 0);
        }
        CHECK(lit > 5000);
        CHECK(forgotten == 0);
    }
}

TEST_CASE("light tree: it is never deeper than the trails have bits") {
    // All in one place, and each twice as far as the one before.
    for (const bool in_one_place : {true, false}) {
        SceneArrays arrays;
        for (int i = 0; i < 60; ++i) {
            const auto x = in_one_place ? Real(0) : static_cast<Real>(std::pow(2.0, i - 30));
            arrays.hittables.push_back(sphere({x, 0, 0}, x > 0 ? x / 4 : Real(1)));
        }
        MaterialRecord m;
        m.emits = 1;
        m.emission.color = Vec3(1);
        arrays.materials.push_back(m);
        build_lights(arrays);
        REQUIRE(arrays.light_nodes.size() == 119);
        std::vector<MeshView> meshes;
        const SceneView view = host_view(arrays, meshes);
        for (uint32_t i = 0; i < view.lights.size; ++i) {
            // The trail leads to the light.
            uint32_t node = 0, depth = 0;
            for (uint32_t trail = view.lights[i].trail; !view.light_nodes[node].is_leaf;
                 trail >>= 1, ++depth)
                node = (trail & 1) ? view.light_nodes[node].next : node + 1;
            CHECK(view.light_nodes[node].next == i);
            CHECK(depth <= kMaxLightTreeDepth);
        }
    }
}

namespace {

// A floor under a thousand small lamps, of which each lights its surroundings.
Scene lamps(LightRule rule, bool sampling) {
    SceneMaker maker;
    maker.scene.render.width = 48;
    maker.scene.render.height = 36;
    maker.camera().look_from = {0, 12, 14};
    maker.camera().vertical_fov = 8;  // a pixel sees one tone
    maker.object(XzRectShape{{-12, -12}, {12, 12}, 0}, maker.lambertian(0.6));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> u(-10, 10), size(0.02, 0.06);
    const MaterialId ids[] = {maker.light(20), maker.light(60)};
    for (int i = 0; i < 1000; ++i)
        maker.sphere({u(random), 0.4, u(random)}, size(random), ids[i % 2]).camera_visible = false;
    maker.path().max_depth = 3;
    maker.path().light_rule = rule;
    maker.path().light_sampling = sampling;
    return maker.scene;
}

double squared_error(const FilmImage& a, const FilmImage& b) {
    double sum = 0;
    for (size_t i = 0; i < a.radiance.size(); ++i)
        sum += std::pow(static_cast<double>(a.radiance[i] - b.radiance[i]), 2);
    return sum;
}

}  // namespace

TEST_CASE("T44: of a thousand lights the tree finds those that matter") {
    const FilmImage exact = render(lamps(LightRule::Tree, true), 1024);
    const FilmImage uniform = render(lamps(LightRule::Uniform, true), 256);
    CHECK(mean(uniform) == doctest::Approx(mean(exact)).epsilon(0.02));
    const double by_tree = squared_error(render(lamps(LightRule::Tree, true), 16), exact);
    const double each_alike = squared_error(render(lamps(LightRule::Uniform, true), 16), exact);
    MESSAGE("squared error at equal samples: uniform over tree " << each_alike / by_tree);
    CHECK(each_alike > 5 * by_tree);
}
