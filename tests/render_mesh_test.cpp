// Pictures of meshes: they equal those of the same surface made of other shapes.
#include "support/meshes.h"
#include "support/scene_maker.h"

#include <teapath/core/color.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>

using namespace tp;
using namespace tp::test;

namespace {

// A sky that differs by direction, a view from above.
SceneMaker open_scene() {
    SceneMaker maker;
    maker.scene.background = {};
    maker.camera().look_from = {3, 2.5, 5};
    return maker;
}

// The largest share of pixels whose red differs by more than a hundredth.
double share_that_differs(const FilmImage& a, const FilmImage& b) {
    size_t count = 0;
    for (size_t i = 0; i < a.radiance.size(); i += 3)
        count += std::abs(a.radiance[i] - b.radiance[i]) > 0.01f;
    return 3 * static_cast<double>(count) / static_cast<double>(a.radiance.size());
}

}  // namespace

TEST_CASE("meshes: a box of triangles gives the picture of a box") {
    for (const Double3 scale : {Double3(1), Double3(0.5, 1.5, -1)}) {
        SceneMaker box = open_scene(), mesh = open_scene();
        const Transform place{{0.2, 0.1, -0.3}, {10, 40, 5}, scale};
        box.object(BoxShape{Double3(-1), Double3(1)}, box.lambertian(0.7)).transform = place;
        mesh.object(mesh_shape(box_mesh()), mesh.lambertian(0.7)).transform = place;
        const FilmImage a = render(box.scene, 16, true), b = render(mesh.scene, 16, true);
        CHECK(share_that_differs(a, b) < 0.01);
        CHECK(mean(a) == doctest::Approx(mean(b)).epsilon(1e-3));
        double normals = 0;
        for (size_t i = 0; i < a.normal.size(); ++i)
            normals += std::abs(static_cast<double>(a.normal[i] - b.normal[i]));
        CHECK(normals / static_cast<double>(a.normal.size()) < 1e-3);
    }
}

TEST_CASE("meshes: a placement comes before the transform") {
    SceneMaker one = open_scene(), other = open_scene();
    one.object(mesh_shape(box_mesh()), one.lambertian(0.7)).transform = {
        {0, 0.5, 0}, {0, 30, 0}, {0.5, 1, 0.5}};
    MeshShape placed = mesh_shape(box_mesh());
    placed.placement = linear_part({{0, 0, 0}, {0, 0, 0}, {0.5, 1, 0.5}});
    other.object(placed, other.lambertian(0.7)).transform = {{0, 0.5, 0}, {0, 30, 0}, {1, 1, 1}};
    CHECK(share_that_differs(render(one.scene, 8), render(other.scene, 8)) < 0.002);
}

TEST_CASE("meshes: smooth normals shade, flat ones where they are switched off") {
    SceneMaker sphere = open_scene(), smooth = open_scene(), flat = open_scene();
    for (SceneMaker* maker : {&sphere, &smooth, &flat})
        maker->camera().vertical_fov = 10;  // nothing of the silhouette
    sphere.sphere({0, 0, 0}, 1, sphere.lambertian(0.7));
    MeshShape ball = mesh_shape(ball_mesh(2));
    smooth.object(ball, smooth.lambertian(0.7));
    ball.smooth = false;
    flat.object(ball, flat.lambertian(0.7));
    const FilmImage exact = render(sphere.scene, 64, true);
    const auto error = [&](const FilmImage& film) {
        double sum = 0;
        for (size_t i = 0; i < exact.normal.size(); ++i)
            sum += std::abs(static_cast<double>(film.normal[i] - exact.normal[i]));
        return sum / static_cast<double>(exact.normal.size());
    };
    const FilmImage soft = render(smooth.scene, 64, true);
    CHECK(mean(soft) == doctest::Approx(mean(exact)).epsilon(0.005));
    CHECK(error(soft) < 0.2 * error(render(flat.scene, 64, true)));
}

TEST_CASE("meshes: a lossless one does not show before a sky of 1") {
    SceneMaker maker;
    maker.background(1);
    Mesh ball = ball_mesh(2);
    ball.normals.clear();
    maker.object(mesh_shape(ball), maker.lambertian(1)).transform.scale = {1, 0.7, 1.2};
    maker.object(mesh_shape(box_mesh()), maker.glass(1.5)).transform = {
        {1.2, 0, 0.5}, {20, 30, 0}, Double3(0.3)};
    maker.path().max_depth = 200;
    maker.path().roulette_depth = 0;
    CHECK(mean(render(maker.scene, 64)) == doctest::Approx(1).epsilon(1e-4));
}

TEST_CASE("meshes: the colours of vertices multiply the material's; images lie upright") {
    SceneMaker maker;
    maker.background(1);
    maker.camera().look_from = {0, 0, 4};
    maker.camera().vertical_fov = 2 * std::atan(0.25) * 180 / 3.14159265358979323846;
    maker.scene.render.width = maker.scene.render.height = 32;
    Mesh square = square_mesh();
    square.colors.assign(4, {0.5f, 1, 1, 1});
    Texture t;
    t.kind = TextureKind::Image;
    Image image{2, 2, 3, PixelFormat::F32, std::vector<std::byte>(2 * 2 * 3 * sizeof(float))};
    const float texels[] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    std::memcpy(image.bytes.data(), texels, sizeof texels);
    t.file = {"four.pfm", std::make_shared<const Image>(image)};
    t.filter = FilterMode::Nearest;
    Material m;
    m.color.texture = maker.texture(t);
    maker.object(mesh_shape(square), maker.material(m));
    const FilmImage film = render(maker.scene, 1, true);
    const auto albedo_is = [&](size_t x, size_t y, const Float3& wanted) {
        const float* p = &film.albedo[3 * (y * 32 + x)];
        return glm::distance(Float3(p[0], p[1], p[2]), wanted) < 1e-5f;
    };
    CHECK(albedo_is(4, 4, {0.5f, 0, 0}));  // top left
    CHECK(albedo_is(27, 4, {0, 1, 0}));
    CHECK(albedo_is(4, 27, {0, 0, 1}));
    CHECK(albedo_is(27, 27, {0.5f, 1, 1}));
}

TEST_CASE("meshes: one that emits is found by light sampling, and gives what chance finds") {
    const auto scene = [](bool is_mesh, bool sampling, double scale_y) {
        SceneMaker maker;
        maker.camera().look_from = {0, 4, 6};
        maker.object(XzRectShape{{-4, -4}, {4, 4}, 0}, maker.lambertian(0.6));
        const MaterialId light = maker.light(5);
        const Transform place{{0, 1.5, 0}, {90, 0, 15}, {1, scale_y, 1}};
        if (is_mesh)
            maker.object(mesh_shape(square_mesh()), light).transform = place;
        else
            maker.object(RectangleShape{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, light).transform =
                place;
        maker.path().light_sampling = sampling;
        return maker.scene;
    };
    for (const double scale : {0.5, -0.5}) {
        const double by_mesh = mean(render(scene(true, true, scale), 256));
        CHECK(by_mesh ==
              doctest::Approx(mean(render(scene(true, false, scale), 2048))).epsilon(0.02));
        if (scale > 0)
            CHECK(by_mesh ==
                  doctest::Approx(mean(render(scene(false, true, scale), 256))).epsilon(0.01));
    }
}

TEST_CASE("meshes: the terminator of a smooth one is that of the surface it stands for") {
    const auto ball = [](bool is_mesh, bool fixed) {
        SceneMaker maker;
        maker.camera().vertical_fov = 18;  // nothing of the silhouette
        const MaterialId grey = maker.lambertian(0.8);
        if (is_mesh)
            maker.object(mesh_shape(ball_mesh(1)), grey);
        else
            maker.sphere({0, 0, 0}, 1, grey);
        maker.sphere({30, 4, 4}, 1, maker.light(1000));
        maker.path().max_depth = 2;
        maker.path().terminator_fix = fixed;
        return render(maker.scene, 64);
    };
    const FilmImage exact = ball(false, false);
    const float brightest = *std::max_element(exact.radiance.begin(), exact.radiance.end());
    const auto error = [&](const FilmImage& film) {
        double sum = 0;
        for (size_t i = 0; i < film.radiance.size(); ++i)
            if (exact.radiance[i] < 0.25f * brightest)
                sum += std::abs(static_cast<double>(film.radiance[i] - exact.radiance[i]));
        return sum;
    };
    const double plain = error(ball(true, false)), fixed = error(ball(true, true));
    MESSAGE("error of the terminator, fixed over plain: " << fixed / plain);
    CHECK(fixed < 0.7 * plain);
}
