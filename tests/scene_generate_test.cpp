// The sphere grid: where its spheres stand, what they are made of, and that it can be repeated.
#include "support/shipped_scenes.h"

#include <teapath/io/scene_file.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace tp;

namespace {

Scene grid_scene(const SphereGrid& grid) {
    Scene scene;
    scene.generators.edit().resize(1);
    scene.generators.edit()[0].id = {1};
    scene.generators.edit()[0].grid = grid;
    return scene;
}

const SphereShape& sphere_of(const Object& object) {
    return std::get<SphereShape>(object.shape);
}

}  // namespace

TEST_CASE("generate: every cell has one sphere, on the ground, inside its cell") {
    SphereGrid grid;
    grid.columns = 7;
    grid.rows = 5;
    grid.spacing = 2;
    grid.center = {10, -20};
    grid.ground = 3;
    grid.radius = 0.25;
    const Scene scene = expand_generators(grid_scene(grid));
    CHECK(scene.generators.empty());
    REQUIRE(scene.objects.size() == 35);
    CHECK(scene.materials.size() == 35);
    for (size_t i = 0; i < scene.objects.size(); ++i) {
        const SphereShape& s = sphere_of(scene.objects[i]);
        const double column = static_cast<double>(i % 7), row = static_cast<double>(i / 7);
        CHECK(s.radius == 0.25);
        CHECK(s.center.y == 3.25);
        const double x = (s.center.x - (10 - 7)) / 2 - column,
                     z = (s.center.z - (-20 - 5)) / 2 - row;
        CHECK((x >= 0 && x < 0.9 && z >= 0 && z < 0.9));
        CHECK(find(scene, scene.objects[i].material) == &scene.materials[i]);
    }
}

TEST_CASE("generate: the box of the centres holds them all, and hardly more") {
    for (const double spacing : {2.0, -0.5})
        for (const double jitter : {0.9, 0.0, -0.7, 3.0}) {
            CAPTURE(spacing);
            CAPTURE(jitter);
            SphereGrid grid;
            grid.columns = 60;
            grid.rows = 40;
            grid.spacing = spacing;
            grid.jitter = jitter;
            grid.center = {3, -4};
            grid.ground = 5;
            const GridBox box = box_of_centers(grid);
            Double3 low(1e9), high(-1e9);
            for (const Object& object : expand_generators(grid_scene(grid)).objects) {
                low = glm::min(low, sphere_of(object).center);
                high = glm::max(high, sphere_of(object).center);
            }
            const double room = 0.2 * std::abs(spacing * jitter) + 1e-9;
            for (int axis = 0; axis < 3; ++axis) {
                CHECK(low[axis] >= box.low[axis] - 1e-9);
                CHECK(low[axis] <= box.low[axis] + room);
                CHECK(high[axis] <= box.high[axis] + 1e-9);
                CHECK(high[axis] >= box.high[axis] - room);
            }
        }
}

TEST_CASE("generate: the same seed gives the same grid, another seed another one") {
    SphereGrid grid;
    const Scene first = expand_generators(grid_scene(grid));
    CHECK(expand_generators(grid_scene(grid)) == first);
    std::set<double> places;
    for (const uint64_t seed : {uint64_t{0}, uint64_t{1}, uint64_t{1} << 32, ~uint64_t{0}}) {
        grid.seed = seed;
        places.insert(sphere_of(expand_generators(grid_scene(grid)).objects[0]).center.x);
    }
    CHECK(places.size() == 4);
}

TEST_CASE("generate: leaving spheres out changes no other, and none is left where it must not be") {
    SphereGrid grid;
    const Scene all = expand_generators(grid_scene(grid));
    grid.keep_clear = {{4, 0.2, 0, 0.9}, {0, 0.2, 0, 3}};
    const Scene some = expand_generators(grid_scene(grid));
    std::map<double, const Object*> by_place;
    for (const Object& o : all.objects)
        by_place[sphere_of(o).center.x] = &o;
    CHECK(all.objects.size() == 484);
    CHECK(some.objects.size() < 475);
    CHECK(some.objects.size() > 440);
    for (const Object& o : some.objects) {
        const Double3 c = sphere_of(o).center;
        CHECK(glm::distance(c, Double3(4, 0.2, 0)) > 0.9);
        CHECK(glm::distance(c, Double3(0, 0.2, 0)) > 3);
        REQUIRE(by_place.count(c.x));
        const Material& before = *find(all, by_place[c.x]->material);
        const Material& after = *find(some, o.material);
        CHECK((before.kind == after.kind && before.color == after.color &&
               before.fuzz == after.fuzz));
    }
}

TEST_CASE("generate: ids go on behind those of the scene, whose own things stay as they are") {
    Scene scene = grid_scene({});
    Object own;
    own.id = {1000};
    scene.objects = {own};
    Material paint;
    paint.id = {77};
    scene.materials = {paint};
    scene.generators.edit().push_back(scene.generators[0]);
    scene.generators.edit()[1].grid.center = {100, 100};
    const Scene expanded = expand_generators(scene);
    CHECK(expanded.objects.size() == 1 + 2 * 484);
    CHECK(expanded.objects[0] == own);
    CHECK(expanded.materials[0] == paint);
    std::set<ObjectId> objects;
    std::set<MaterialId> materials;
    for (const Object& o : expanded.objects)
        objects.insert(o.id);
    for (const Material& m : expanded.materials)
        materials.insert(m.id);
    CHECK(objects.size() == expanded.objects.size());
    CHECK(materials.size() == expanded.materials.size());
    CHECK(objects.begin()->value == 1000);
}

TEST_CASE("generate: T37's rule of colours, and that of the thesis' text") {
    SphereGrid grid;
    grid.columns = grid.rows = 100;
    double lambertian[2] = {0, 0}, metal[2] = {0, 0};
    for (const bool thesis : {false, true}) {
        grid.thesis_colors = thesis;
        int lambertians = 0, metals = 0;
        for (const Material& m : expand_generators(grid_scene(grid)).materials) {
            const double red = m.color.color.x;
            if (m.kind == MaterialKind::Lambertian) lambertian[thesis] += red, ++lambertians;
            if (m.kind == MaterialKind::Metal) metal[thesis] += red, ++metals;
            if (m.kind == MaterialKind::Dielectric) CHECK(m.color.color == Double3(1));
        }
        lambertian[thesis] /= lambertians;
        metal[thesis] /= metals;
    }
    CHECK(lambertian[0] == doctest::Approx(0.25).epsilon(0.05));     // E[u v]
    CHECK(lambertian[1] == doctest::Approx(1.0 / 3).epsilon(0.05));  // E[u^2]
    CHECK(metal[0] == doctest::Approx(0.75).epsilon(0.05));          // E[0.5 (1 + u)]
    CHECK(metal[1] == doctest::Approx(0.5).epsilon(0.05));           // E[(u + 0.5) / 2]
}

TEST_CASE("T37: over 1000 seeds the materials have their probabilities, counts within 3 sigma") {
    SphereGrid grid;
    grid.columns = grid.rows = 10;
    constexpr int kSeeds = 1000, kSpheres = 100;
    const double wanted[3] = {0.8, 0.15, 0.05};
    int total[3] = {0, 0, 0}, outside[3] = {0, 0, 0};
    double fuzz = 0;
    for (int seed = 0; seed < kSeeds; ++seed) {
        grid.seed = static_cast<uint64_t>(seed);
        int count[3] = {0, 0, 0};
        for (const Material& m : expand_generators(grid_scene(grid)).materials) {
            ++count[static_cast<int>(m.kind)];  // in the order of the probabilities
            fuzz = std::max(fuzz, m.fuzz);
        }
        for (int k = 0; k < 3; ++k) {
            total[k] += count[k];
            const double sigma = std::sqrt(kSpheres * wanted[k] * (1 - wanted[k]));
            outside[k] += std::abs(count[k] - kSpheres * wanted[k]) > 3 * sigma;
        }
    }
    constexpr double kAll = kSeeds * kSpheres;
    for (int k = 0; k < 3; ++k) {
        CAPTURE(k);
        const double sigma = std::sqrt(kAll * wanted[k] * (1 - wanted[k]));
        CHECK(std::abs(total[k] - kAll * wanted[k]) < 3 * sigma);
        CHECK(outside[k] < 15);  // a few in a thousand; the binomial of 5 in 100 has a tail
    }
    CHECK(fuzz <= 0.5);
    CHECK(fuzz > 0.49);
}

TEST_CASE("generate: the shipped scenes have as many spheres as their names say") {
    const auto count = [](const char* file) {
        return expand_generators(load_scene(test::scene_folder() / file)).objects.size();
    };
    CHECK(count("thesis/ten_thousand_spheres.json") == 10001);
    CHECK(count("thesis/experiment.json") == 101);
    // The book's cover has 488 objects with its own random numbers.
    CHECK(count("weekend/12_final.json") > 470);
    CHECK(count("weekend/12_final.json") <= 488);
}
