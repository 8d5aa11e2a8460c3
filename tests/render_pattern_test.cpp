// Textures made by formulae, the space they lie in, triplanar images, bump maps.
#include "support/meshes.h"
#include "support/scene_maker.h"

#include <teapath/device/host_view.h>
#include <teapath/kernel/bump.h>
#include <teapath/kernel/traverse.h>

#include <cmath>
#include <cstring>
#include <random>

using namespace tp;
using namespace tp::test;

namespace {

// A scene's arrays and the view of them, for look-ups without a render.
struct Lookup {
    SceneArrays arrays;
    std::vector<MeshView> meshes;
    SceneView view;

    explicit Lookup(const Scene& scene) {
        flatten(scene, SceneParts::All, arrays);
        view = host_view(arrays, meshes);
    }
    Vec4 at(uint32_t texture, const TexturePoint& point) const {
        return color_at(view, ColorRef{{0, 0, 0}, static_cast<int32_t>(texture)}, point);
    }
    Vec4 at(Double3 position, Double3 normal = {0, 0, 1}) const {
        return at(0, {{0, 0}, {0, 0}, Vec3(position), Vec3(normal)});
    }
    uint32_t hittable_of(ObjectId object) const {
        for (uint32_t i = 0; i < arrays.hittables.size(); ++i)
            if (arrays.hittables[i].object == object.value) return i;
        return kNoHit;
    }
    // What a ray sees.
    Surface surface(Double3 from, Double3 to) const {
        const Vec3 origin(from), direction(glm::normalize(to - from));
        const Hit hit = intersect_scene<kFeatureAll>(view, origin, direction, kInfinity);
        REQUIRE(hit.index != kNoHit);
        return make_surface<kFeatureAll>(view, view.hittables[hit.index], origin, direction, hit);
    }
    // The normal there with texture 0 as a bump map.
    Double3 bumped(Double3 from, Double3 to, double scale) const {
        const Surface s = surface(from, to);
        return Double3(bumped_normal(view, 0, static_cast<Real>(scale), s, s.normal,
                                     Vec3(glm::normalize(from - to))));
    }
};

Lookup lookup(const Texture& t) {
    SceneMaker maker;
    maker.texture(t);
    return Lookup(maker.scene);
}

Texture pattern(TextureKind kind, TextureSpace space = TextureSpace::World) {
    Texture t;
    t.kind = kind;
    t.space = space;
    return t;
}

// The first colour red, the second green: a mix shows the shares.
Texture shares(TextureKind kind) {
    Texture t = pattern(kind);
    for (TexturedColor* first : {&t.low, &t.stone, &t.early, &t.brick})
        first->color = {1, 0, 0};
    for (TexturedColor* second : {&t.high, &t.vein, &t.late, &t.mortar})
        second->color = {0, 1, 0};
    return t;
}

// A float image of `size` texels along u, value (i + 0.5) / size: u itself between the outermost.
Texture ramp(int size) {
    std::vector<float> values;
    for (int i = 0; i < size; ++i)
        values.push_back((static_cast<float>(i) + 0.5f) / static_cast<float>(size));
    auto image = std::make_shared<Image>();
    *image = {size, 1, 1, PixelFormat::F32, std::vector<std::byte>(values.size() * sizeof(float))};
    std::memcpy(image->bytes.data(), values.data(), image->bytes.size());
    Texture t;
    t.kind = TextureKind::Image;
    t.wrap = WrapMode::Clamp;
    t.file = {"ramp.exr", std::move(image)};
    return t;
}

void check_near(Double3 a, Double3 b, double tolerance) {
    CAPTURE(a.x);
    CAPTURE(a.y);
    CAPTURE(a.z);
    CAPTURE(b.x);
    CAPTURE(b.y);
    CAPTURE(b.z);
    CHECK(glm::length(a - b) < tolerance);
}

}  // namespace

TEST_CASE("noise textures: the noise of noise.h between two colours") {
    Texture t = shares(TextureKind::Noise);
    t.seed = 5;
    t.contrast = 0.8;
    t.scale = {2, 3, 4};
    t.octaves = 3;
    const NoiseHash hash = noise_hash(uint64_t{5});
    const NoiseOctaves octaves{3, Real(2), Real(0.5)};
    const Double3 place{0.31, -1.73, 2.45};
    const Vec3 p = Vec3(place * t.scale);
    const auto share = [&](NoisePattern which) {
        t.pattern = which;
        const Vec4 c = lookup(t).at(place);
        CHECK(c.x + c.y == doctest::Approx(1));
        CHECK(c.w == doctest::Approx(1));
        return c.y;
    };
    CHECK(share(NoisePattern::Gradient) ==
          doctest::Approx(0.5 + 0.8 * double(gradient_noise(hash, p).value)));
    CHECK(share(NoisePattern::Fbm) ==
          doctest::Approx(0.5 + 0.8 * double(fbm(hash, p, octaves).value)));
    CHECK(share(NoisePattern::Turbulence) ==
          doctest::Approx(1.6 * double(turbulence(hash, p, octaves))));
    CHECK(share(NoisePattern::Ridged) ==
          doctest::Approx(0.5 + 0.8 * (double(ridged_noise(hash, p, octaves)) - 0.5)));
    t.pattern = NoisePattern::Gradient;
    CHECK(lookup(t).at({0.5, -1.0 / 3, 0.25}).y == doctest::Approx(0.5));  // a lattice point
    t.contrast = 100;
    const Real far = lookup(t).at(place).y;
    CHECK((far == 0 || far == 1));
    t.contrast = 0;
    CHECK(lookup(t).at(place).y == doctest::Approx(0.5));
    // By texture coordinates, whatever the place.
    t.contrast = 1;
    t.space = TextureSpace::Uv;
    const Lookup uv = lookup(t);
    const TexturePoint here{{Real(0.3), Real(0.7)}, {0, 0}, {5, 6, 7}};
    CHECK(uv.at(0, here).y ==
          doctest::Approx(0.5 + double(gradient_noise(hash, Vec3(Double3(0.6, 2.1, 0))).value)));
}

TEST_CASE("brick: courses with joints, shifted row by row, on each side of a box") {
    Texture t = shares(TextureKind::Brick);
    t.brick_size = {0.4, 0.1};
    t.mortar_width = 0.02;
    t.mortar_blend = 0;
    t.variation = 0;
    t.row_offset = 0.25;
    const Lookup l = lookup(t);
    const auto is_brick = [&](double across, double down) {
        const Vec4 c = l.at({across, -down, 0.37});
        CHECK(c.x + c.y == doctest::Approx(1));
        return c.x > Real(0.5);
    };
    CHECK(is_brick(0.2, 0.05));
    CHECK_FALSE(is_brick(0.005, 0.05));   // the joint between two bricks
    CHECK_FALSE(is_brick(-0.005, 0.05));  // its other half
    CHECK(is_brick(0.015, 0.05));
    CHECK_FALSE(is_brick(0.2, 0.1));     // the joint between rows
    CHECK_FALSE(is_brick(0.305, 0.15));  // a row further, a quarter of a brick to the left
    CHECK(is_brick(0.01, 0.15));
    CHECK_FALSE(is_brick(0.205, 0.25));
    CHECK(l.at({0.37, -0.05, -0.2}, {1, 0, 0}).x == 1);
    CHECK(l.at({0.37, -0.05, 0.0}, {1, 0, 0}).x == 0);
    CHECK(l.at({0.2, 0.37, 0.05}, {0, 1, 0}).x == 1);
    CHECK(l.at({0.0, 0.37, 0.05}, {0, 1, 0}).x == 0);
    // Single bricks are darker, all of one alike.
    t.variation = 0.5;
    const Lookup varied = lookup(t);
    const Real one = varied.at({0.2, -0.05, 0}).x;
    CHECK(one >= Real(0.5));
    CHECK(varied.at({0.1, -0.03, 0}).x == one);
    CHECK(varied.at({0.6, -0.05, 0}).x != one);
    // Soft joints.
    t.mortar_blend = 1;
    const Real soft = lookup(t).at({0.2, -0.02, 0}).y;
    CHECK(soft == doctest::Approx(0.5).epsilon(1e-3));
}

TEST_CASE("wood: rings about an axis; marble: veins between layers") {
    Texture t = shares(TextureKind::Wood);
    t.distortion = t.grain = 0;
    t.scale = Double3(2);
    t.axis = Axis::X;
    const Lookup wood = lookup(t);
    CHECK(wood.at({7.3, 0.5, 0}).y == doctest::Approx(0));  // a ring begins
    CHECK(wood.at({0, 0.3, 0.4}).y == doctest::Approx(0));
    CHECK(wood.at({-3, 0, 0.424}).y > Real(0.95));  // and ends dark
    CHECK(wood.at({1, 0.2125, 0}).y == doctest::Approx(0.25).epsilon(1e-3));
    t.grain = 1;
    const Vec4 fibres = lookup(t).at({0.2, 0.11, 0.13});
    CHECK(fibres.x + fibres.y < 1);

    t = shares(TextureKind::Marble);
    t.distortion = 0;
    t.vein_power = 4;
    t.axis = Axis::Z;
    t.scale = Double3(1);
    const Lookup marble = lookup(t);
    Real most = 0;
    for (int i = 0; i < 100; ++i) {
        CHECK(marble.at({0.37 * i, 0.61 * i, 2.5}).y == doctest::Approx(0));
        most = std::max(most, marble.at({0.37 * i, 0.61 * i, 3}).y);
    }
    CHECK(most > Real(0.9));
}

TEST_CASE("patterns nest, and checkers and images with them") {
    SceneMaker maker;
    Texture outer = pattern(TextureKind::Noise), inner = pattern(TextureKind::Marble),
            board = pattern(TextureKind::Checker), core = pattern(TextureKind::Wood),
            last = pattern(TextureKind::Brick);
    outer.low.texture = {2};
    outer.high.texture = {3};
    board.mode = CheckerMode::World;
    board.even.texture = {2};
    board.odd.texture = {4};
    inner.stone.texture = {4};
    inner.vein.texture = {5};
    core.early.texture = {5};
    for (const Texture& t : {outer, inner, board, core, last})
        maker.texture(t);
    const Lookup l(maker.scene);
    const auto mix = [&](int texture, const TexturePoint& p) {
        const TextureRecord& r = l.arrays.textures[static_cast<size_t>(texture)];
        return pattern_mix(l.view, r.kind, r.pattern, p);
    };
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-3, 3);
    for (int i = 0; i < 300; ++i) {
        const Double3 p{place(random), place(random), place(random)};
        const TexturePoint point{{0, 0}, {0, 0}, Vec3(p)};
        const PatternMix brick = mix(4, point), wood = mix(3, point), marble = mix(1, point),
                         noise = mix(0, point);
        const Vec3 of_brick =
            lerp(Vec3(last.brick.color) * brick.shade, Vec3(last.mortar.color), brick.share);
        const Vec3 of_wood = lerp(of_brick * wood.shade, Vec3(core.late.color), wood.share);
        const Vec3 of_marble = lerp(of_wood * marble.shade, of_brick, marble.share);
        const bool even = is_even_cell(l.arrays.textures[2].checker, point.uv, point.position);
        const Vec3 of_board = even ? of_marble : of_wood;
        const Vec3 of_noise = lerp(of_marble * noise.shade, of_board, noise.share);
        check_near(Double3(Vec3(l.at(0, point))), Double3(of_noise), 1e-5);
        CHECK(l.at(0, point).w == doctest::Approx(1));
    }
}

TEST_CASE("a pattern in object space goes with the object: shapes, ellipsoids, meshes") {
    const Transform moved{{1, -2, 3}, {20, 40, 60}, {1, 2, 0.5}};
    SceneMaker maker;
    Texture solid = pattern(TextureKind::Noise, TextureSpace::Object);
    Texture fixed = pattern(TextureKind::Noise, TextureSpace::World);
    maker.texture(solid);
    maker.texture(fixed);
    const MaterialId paint = maker.lambertian(0.5);
    const Shape shapes[] = {SphereShape{}, BoxShape{}, XzRectShape{}, mesh_shape(box_mesh())};
    for (const Shape& shape : shapes) {
        maker.object(shape, paint).transform = moved;
        maker.object(shape, paint);
    }
    const Lookup l(maker.scene);
    const DoubleMat4 map = world_from_object(moved);
    const Double3 p{0.3, -0.2, 0.4};
    const TexturePoint world{{0, 0}, {0, 0}, Vec3(p)};
    const Real wanted = l.at(1, world).x;
    for (uint32_t i = 0; i < 8; ++i) {
        CAPTURE(i);
        TexturePoint point = world;
        point.hittable = l.hittable_of({i + 1});
        REQUIRE(point.hittable != kNoHit);
        if (i % 2 == 0) point.position = Vec3(Double3(map * Double4(p, 1)));
        CHECK(l.at(0, point).x == doctest::Approx(double(wanted)).epsilon(1e-4));
        // Normals stay across what they were across.
        const Double3 n{0.6, 0, 0.8}, along{0.8, 0.5, -0.6};
        const DoubleMat3 linear(map);
        if (i % 2 == 0)
            point.normal = Vec3(glm::normalize(glm::transpose(glm::inverse(linear)) * n));
        else
            point.normal = Vec3(n);
        const Double3 back(point_in(l.view, TextureSpace::Object, point).normal);
        check_near(glm::normalize(back), n, 1e-5);
        CHECK(std::abs(glm::dot(back, along)) < 1e-5 * glm::length(back));
    }
    CHECK(l.arrays.placements.size() == 3);
    CHECK((l.arrays.features & kFeatureProcedural) != 0);
    SceneMaker plain;
    plain.texture(pattern(TextureKind::Checker));
    plain.texture(ramp(4));
    CHECK((Lookup(plain.scene).arrays.features & kFeatureProcedural) == 0);
}

TEST_CASE("triplanar: on the sides of a box as an image laid on each, mixed between them") {
    std::vector<float> values;
    for (int i = 0; i < 25; ++i)
        values.push_back(static_cast<float>(i * 7 % 25) / 25);
    auto image = std::make_shared<Image>();
    *image = {5, 5, 1, PixelFormat::F32, std::vector<std::byte>(values.size() * sizeof(float))};
    std::memcpy(image->bytes.data(), values.data(), image->bytes.size());
    Texture planar;
    planar.kind = TextureKind::Image;
    planar.file = {"a.exr", image};
    Texture triplanar = planar;
    triplanar.projection = TextureProjection::Triplanar;
    triplanar.uv_offset = {0.5, 0.5};  // the box is about the origin
    SceneMaker maker;
    maker.texture(planar);
    maker.texture(triplanar);
    Object& box = maker.object(BoxShape{}, maker.lambertian(0.5));
    box.transform = {{3, 1, 2}, {30, 50, 10}, {1, 1, 1}};
    const DoubleMat4 map = world_from_object(box.transform);
    const Lookup l(maker.scene);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(-0.45, 0.45);
    for (int i = 0; i < 120; ++i) {
        Double3 out(0), to{place(random), place(random), place(random)};
        out[i % 3] = i % 2 ? 3 : -3;
        to[i % 3] = i % 2 ? 0.5 : -0.5;
        const Surface s =
            l.surface(Double3(map * Double4(to + out, 1)), Double3(map * Double4(to, 1)));
        const TexturePoint at = texture_point<kFeatureAll>(s);
        CHECK(l.at(1, at).x == doctest::Approx(double(l.at(0, at).x)).epsilon(1e-3));
    }
    // Half of each where two sides meet; the sharper, the less of the far one.
    const Double3 p{0.13, 0.21, 0.32};
    const auto mixed = [&](double sharpness, Double3 n) {
        Texture t = triplanar;
        t.sharpness = sharpness;
        return double(lookup(t).at(p, glm::normalize(n)).x);
    };
    const double x = mixed(4, {1, 0, 0}), y = mixed(4, {0, 1, 0});
    CHECK(mixed(4, {1, 1, 0}) == doctest::Approx((x + y) / 2));
    CHECK(mixed(1, {2, 1, 0}) == doctest::Approx((2 * x + y) / 3));
    CHECK(mixed(2, {2, 1, 0}) == doctest::Approx((4 * x + y) / 5));
}

TEST_CASE("bump: a ramp on a plane gives the normal of the slope, from both sides") {
    SceneMaker maker;
    maker.texture(ramp(64));
    const MaterialId paint = maker.lambertian(0.5);
    maker.object(XzRectShape{{0, 0}, {2, 2}, 0}, paint);  // u along x, 2 units
    maker.object(mesh_shape(box_mesh()), paint).transform = {{10, 0, 0}, {0, 0, 0}, {1, 1, 1}};
    maker.object(BoxShape{}, paint).transform.translation = {20, 0, 0};
    maker.sphere({30, 0, 0}, 2, paint);
    maker.object(DiskShape{{40, 0, 0}, {0, 1, 0}, 2}, paint);
    const Lookup l(maker.scene);
    const auto slope = [](double x) { return glm::normalize(Double3(-x, 1, 0)); };
    check_near(l.bumped({1, 3, 1}, {1, 0, 1}, 0.8), slope(0.4), 1e-3);
    check_near(l.bumped({0.2, 3, 1.1}, {1, 0, 1}, -0.8), slope(-0.4), 1e-3);
    check_near(l.bumped({1, -3, 1}, {1, 0, 1}, 0.8), -slope(0.4), 1e-3);
    check_near(l.bumped({1, 3, 1}, {1, 0, 1}, 0), {0, 1, 0}, 1e-6);
    // A box 1 wide, its top.
    check_near(l.bumped({20, 3, 0}, {20.1, 0, 0.1}, 0.5), slope(0.5), 1e-3);
    // A sphere's u runs eastwards, once around its circle.
    const double around = 2 * 3.14159265358979323846 * 2;
    check_near(l.bumped({30, 0, 9}, {30, 0, 0}, 4), glm::normalize(Double3(-4 / around, 0, 1)),
               1e-3);
    // A disk's u is an angle: at radius 1 it runs a whole turn on 2 pi.
    const Double3 normal = l.bumped({39.5, 3, 0.8}, {39.5, 0, 0.8}, 0.6);
    CHECK(normal.y == doctest::Approx(1 / std::hypot(1, 0.6 / (around / 2) / std::hypot(0.5, 0.8)))
                          .epsilon(1e-3));
    CHECK(std::abs(glm::dot(normal, glm::normalize(Double3(-0.5, 0, 0.8)))) < 1e-3);
}

TEST_CASE("bump: noise raises the surface by its own gradient; meshes by their coordinates") {
    Texture t = shares(TextureKind::Noise);
    t.low.color = Double3(0);
    t.high.color = Double3(1);
    t.pattern = NoisePattern::Gradient;
    t.scale = Double3(1.5);
    SceneMaker maker;
    maker.texture(t);
    maker.object(XyRectShape{{-5, -5}, {5, 5}, 0.3}, maker.lambertian(0.5));
    const Lookup l(maker.scene);
    const NoiseHash hash = noise_hash(uint64_t{0});
    for (int i = 0; i < 40; ++i) {
        const Double3 p{0.21 * i - 4, 0.17 * i - 3, 0.3};
        const Double3 g = Double3(gradient_noise(hash, Vec3(p * 1.5)).gradient) * 1.5 * 0.4;
        check_near(l.bumped(p + Double3(0, 0, 2), p, 0.4), glm::normalize(Double3(-g.x, -g.y, 1)),
                   4e-3);
    }

    // A square of two triangles, 3 by 2 units, whose u runs along y.
    Mesh square;
    square.positions = {{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    square.uvs = {{{0, 1}, {0, 0}, {1, 0}, {1, 1}}};
    SceneMaker mesh;
    mesh.texture(ramp(64));
    mesh.object(mesh_shape(square), mesh.lambertian(0.5)).transform.scale = {1, 2, 1};
    const Lookup m(mesh.scene);
    check_near(m.bumped({1, 1, 4}, {1, 1, 0}, 1), glm::normalize(Double3(0, -0.25, 1)), 1e-3);
}

TEST_CASE("bump: the normal faces the eye however steep, and adds to a normal map") {
    SceneMaker maker;
    Texture t = shares(TextureKind::Noise);
    t.high.color = Double3(1);
    maker.texture(t);
    maker.sphere({0, 0, 0}, 1, maker.lambertian(0.5));
    const Lookup l(maker.scene);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-0.99, 0.99);
    for (int i = 0; i < 500; ++i) {
        const Double3 from{4 * place(random), 4 * place(random), 3};
        const Surface s = l.surface(from, {0, 0, 0});
        const Vec3 wo(glm::normalize(from));
        for (const double scale : {0.01, 1.0, 100.0}) {
            const Vec3 n = bumped_normal(l.view, 0, static_cast<Real>(scale), s, s.normal, wo);
            CHECK(length(n) == doctest::Approx(1));
            CHECK(dot(n, wo) > 0);
        }
    }
    // A tilted normal stays tilted by about as much.
    SceneMaker plane;
    plane.texture(ramp(64));
    plane.object(XzRectShape{{0, 0}, {2, 2}, 0}, plane.lambertian(0.5));
    const Lookup p(plane.scene);
    const Surface s = p.surface({1, 3, 1}, {1, 0, 1});
    const Double3 tilted = glm::normalize(Double3(0, 1, 0.3));
    check_near(Double3(bumped_normal(p.view, 0, Real(0.8), s, Vec3(tilted), {0, 1, 0})),
               glm::normalize(Double3(-0.4, 1, 0.3)), 1e-3);
}

TEST_CASE("patterns: light sampling and the bsdf see the same emission") {
    const auto brightness = [](bool aims) {
        SceneMaker maker;
        maker.background(0);
        maker.path().light_sampling = aims;
        maker.path().max_depth = 2;
        maker.camera().look_from = {0, 2, 5};
        Texture t = shares(TextureKind::Noise);
        t.space = TextureSpace::Object;
        t.contrast = 5;
        Material lamp;
        lamp.kind = MaterialKind::DiffuseLight;
        lamp.emission.texture = maker.texture(t);
        lamp.strength = 3;
        const MaterialId light = maker.material(lamp);
        maker.object(XzRectShape{{-4, -4}, {4, 4}, 0}, maker.lambertian(0.7));
        maker.object(mesh_shape(ball_mesh(2)), light).transform = {
            {0.8, 1.2, 0}, {30, 0, 20}, Double3(0.7)};
        maker.sphere({-1, 1, 0}, 0.6, light).transform.rotation = {0, 50, 0};
        return mean(render(maker.scene, aims ? 64 : 512));
    };
    CHECK(brightness(true) == doctest::Approx(brightness(false)).epsilon(0.02));
}
