// Textures and backgrounds: look-up rules, seams, missing images, orientation.
#include "support/scene_maker.h"

#include <teapath/kernel/background.h>

#include <cmath>
#include <cstring>
#include <initializer_list>

using namespace tp;
using namespace tp::test;

namespace {

// A scene's arrays and the view of them, for look-ups without a render.
struct Lookup {
    SceneArrays arrays;
    SceneView view;
    std::vector<float> table;

    explicit Lookup(const Scene& scene) {
        flatten(scene, SceneParts::All, arrays);
        for (int i = 0; i < 256; ++i)
            table.push_back(linear_from_srgb(static_cast<float>(i) / 255.0f));
        view.textures = make_span(std::as_const(arrays.textures));
        view.texels = reinterpret_cast<const unsigned char*>(arrays.texels.data());
        view.srgb_table = table.data();
        view.background = arrays.background;
    }
    Vec4 at(double u, double v) const {
        return color_at(view, ColorRef{{0, 0, 0}, 0},
                        {{static_cast<Real>(u), static_cast<Real>(v)}, {0, 0}, {0, 0, 0}});
    }
};

template <class T>
std::shared_ptr<Image> make_image(int width, int height, int channels, PixelFormat format,
                                  const std::vector<T>& values) {
    auto image = std::make_shared<Image>();
    *image = {width, height, channels, format, std::vector<std::byte>(values.size() * sizeof(T))};
    std::memcpy(image->bytes.data(), values.data(), image->bytes.size());
    return image;
}

Texture image_texture(std::shared_ptr<const Image> image) {
    Texture t;
    t.kind = TextureKind::Image;
    t.file = {"test.png", std::move(image)};
    return t;
}

// 4 x 1 float texels 0, 1, 2, 3.
Texture ramp() {
    return image_texture(make_image<float>(4, 1, 1, PixelFormat::F32, {0, 1, 2, 3}));
}

Lookup lookup(const Texture& t) {
    SceneMaker maker;
    maker.texture(t);
    return Lookup(maker.scene);
}

}  // namespace

TEST_CASE("T18: wrap, clamp and mirror at the edges, nearest and bilinear") {
    Texture t = ramp();
    t.filter = FilterMode::Nearest;
    for (const auto& [at, repeat, clamp, mirror] : {std::tuple{-0.1, 3, 0, 0},
                                                    {0.1, 0, 0, 0},
                                                    {0.9, 3, 3, 3},
                                                    {1.1, 0, 3, 3},
                                                    {1.4, 1, 3, 2},
                                                    {-1.1, 3, 0, 3}}) {
        const double u = at;  // a structured binding cannot be captured
        CAPTURE(u);
        t.wrap = WrapMode::Repeat;
        CHECK(lookup(t).at(u, 0.5).x == repeat);
        t.wrap = WrapMode::Clamp;
        CHECK(lookup(t).at(u, 0.5).x == clamp);
        t.wrap = WrapMode::Mirror;
        CHECK(lookup(t).at(u, 0.5).x == mirror);
    }
    t.filter = FilterMode::Bilinear;
    t.wrap = WrapMode::Repeat;
    CHECK(lookup(t).at(0.125, 0.5).x == doctest::Approx(0));  // a texel's centre
    CHECK(lookup(t).at(0.25, 0.5).x == doctest::Approx(0.5));
    CHECK(lookup(t).at(0, 0.5).x == doctest::Approx(1.5));  // between the last and the first
    t.wrap = WrapMode::Clamp;
    CHECK(lookup(t).at(0, 0.5).x == doctest::Approx(0));
    t.wrap = WrapMode::Mirror;
    CHECK(lookup(t).at(1, 0.5).x == doctest::Approx(3));
    t.wrap = WrapMode::Repeat;
    t.repeat = {2, 1};
    CHECK(lookup(t).at(0.0625, 0.5).x == doctest::Approx(0));
    CHECK(std::isfinite(lookup(t).at(1e30, -1e30).x));
}

TEST_CASE("T18: bit depths, alpha, and sRGB decoded texel by texel") {
    const Lookup u8 =
        lookup(image_texture(make_image<uint8_t>(1, 1, 4, PixelFormat::U8, {188, 0, 255, 128})));
    CHECK(u8.at(0.5, 0.5).x == doctest::Approx(0.5029).epsilon(1e-3));
    CHECK(u8.at(0.5, 0.5).z == doctest::Approx(1));
    CHECK(u8.at(0.5, 0.5).w == doctest::Approx(128.0 / 255));  // alpha is linear
    const Lookup u16 =
        lookup(image_texture(make_image<uint16_t>(1, 1, 1, PixelFormat::U16, {188 * 257})));
    CHECK(u16.at(0.5, 0.5).x == doctest::Approx(0.5029).epsilon(1e-3));
    CHECK(u16.at(0.5, 0.5).y == u16.at(0.5, 0.5).x);
    const Lookup f32 =
        lookup(image_texture(make_image<float>(1, 1, 3, PixelFormat::F32, {40, 0.5f, -1})));
    CHECK(f32.at(0.5, 0.5).x == 40);
    Texture linear = image_texture(make_image<uint8_t>(1, 1, 1, PixelFormat::U8, {51}));
    linear.color_space = ColorSpace::Linear;
    CHECK(lookup(linear).at(0.5, 0.5).x == doctest::Approx(0.2));
}

TEST_CASE("a missing image is cyan") {
    const Vec4 c = lookup(image_texture(nullptr)).at(0.3, 0.3);
    CHECK(Vec3(c) == Vec3(0, 1, 1));
}

TEST_CASE("E17: checkers by texture coordinates and by world position, nested") {
    SceneMaker maker;
    Texture outer, inner;
    outer.kind = inner.kind = TextureKind::Checker;
    outer.cells = {2, 2};
    outer.even.color = Double3(1);
    outer.odd.texture = {2};
    inner.cells = {4, 4};
    inner.even.color = Double3(0.5);
    inner.odd.color = Double3(0.25);
    maker.texture(outer);
    maker.texture(inner);
    const Lookup l(maker.scene);
    CHECK(l.at(0.1, 0.1).x == 1);
    CHECK(l.at(0.6, 0.1).x == Real(0.5));
    CHECK(l.at(0.8, 0.1).x == Real(0.25));
    CHECK(l.at(-0.1, 0.1).x == Real(0.25));

    Texture world;
    world.kind = TextureKind::Checker;
    world.mode = CheckerMode::World;
    world.frequency = 10;
    SceneMaker other;
    other.texture(world);
    const Lookup w(other.scene);
    for (int i = 0; i < 100; ++i) {
        const Vec3 p(Double3(0.37 * i, 0.11 * i + 0.01, 1.7 - 0.05 * i));
        const bool even =
            std::sin(10 * double(p.x)) * std::sin(10 * double(p.y)) * std::sin(10 * double(p.z)) >=
            0;
        CHECK(color_at(w.view, ColorRef{{0, 0, 0}, 0}, {{0, 0}, {0, 0}, p}).x ==
              doctest::Approx(even ? 0.9 : 0.2));
    }
}

TEST_CASE("T12: gradient ends, and an equirectangular background without a seam") {
    SceneMaker maker;
    maker.scene.background.kind = BackgroundKind::Gradient;
    const Lookup gradient(maker.scene);
    CHECK(background_radiance<kFeatureAll>(gradient.view, {0, 1, 0}) == Vec3(Double3(0.5, 0.7, 1)));
    CHECK(background_radiance<kFeatureAll>(gradient.view, {0, -1, 0}) == Vec3(1, 1, 1));

    // 8 x 4: the column number is the value.
    std::vector<float> values;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x)
            values.push_back(static_cast<float>(x));
    maker.scene.background.kind = BackgroundKind::Image;
    maker.scene.background.file = {"sky.hdr", make_image<float>(8, 4, 1, PixelFormat::F32, values)};
    const Lookup sky(maker.scene);
    const auto at = [&](double x, double y, double z) {
        return background_radiance<kFeatureAll>(sky.view, normalize(Vec3(Double3(x, y, z)))).x;
    };
    CHECK(at(1, 0, 0) == doctest::Approx(1.5));   // a quarter from the left
    CHECK(at(0, 0, 1) == doctest::Approx(3.5));   // the middle
    CHECK(at(-1, 0, 0) == doctest::Approx(5.5));  // three quarters
    CHECK(std::abs(at(1e-4, 0, -1) - at(-1e-4, 0, -1)) < 8.0 / 255);
    maker.scene.background.rotation = 90;
    const Lookup turned(maker.scene);
    CHECK(background_radiance<kFeatureAll>(turned.view, {1, 0, 0}).x != at(1, 0, 0));
}

TEST_CASE("an image stands upright on each rectangle seen from its front") {
    // Top left red channel 1, the rest 0.
    const auto image = make_image<float>(2, 2, 1, PixelFormat::F32, {1, 0, 0, 0});
    const auto corner_value = [&](Shape shape, Double3 from, Double3 up, bool left, bool top) {
        SceneMaker maker;
        Texture t = image_texture(image);
        t.filter = FilterMode::Nearest;
        Material m;
        m.kind = MaterialKind::DiffuseLight;
        m.emission.texture = maker.texture(t);
        m.side = EmissionSide::Front;
        maker.object(std::move(shape), maker.material(m));
        maker.camera().look_from = from;
        maker.camera().up = up;
        maker.camera().vertical_fov =
            9;  // the unit square just fits in 48 of 48 rows from 5 units, nearly
        return red(render(maker.scene, 4), left ? 22 : 42, top ? 14 : 34);
    };
    const auto check_upright = [&](Shape shape, Double3 from, Double3 up) {
        CHECK(corner_value(shape, from, up, true, true) == doctest::Approx(1));
        CHECK(corner_value(shape, from, up, false, true) == 0);
        CHECK(corner_value(shape, from, up, true, false) == 0);
    };
    check_upright(XyRectShape{}, {0, 0, 6}, {0, 1, 0});
    check_upright(YzRectShape{}, {6, 0, 0}, {0, 1, 0});
    check_upright(XzRectShape{}, {0, 6, 0}, {0, 0, -1});
    check_upright(BoxShape{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, {0, 0, 6.5}, {0, 1, 0});
    check_upright(BoxShape{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, {-6.5, 0, 0}, {0, 1, 0});
    check_upright(BoxShape{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, {0, 6.5, 0}, {0, 0, -1});
}

TEST_CASE("opacity: a half-open screen lets half through, with its colour, in shadows too") {
    SceneMaker maker;
    maker.background(0);
    Material screen;
    screen.color.color = Double3(0);
    screen.opacity = 0.25;
    screen.pass_through = {1, 0.5, 0};
    const MaterialId screen_id = maker.material(screen);
    maker.object(XyRectShape{{-50, -50}, {50, 50}, 2}, screen_id);
    maker.object(XyRectShape{{-50, -50}, {50, 50}, 0}, maker.light(1));
    const FilmImage film = render(maker.scene, 4096);
    double sums[3] = {0, 0, 0};
    for (size_t i = 0; i < film.radiance.size(); ++i)
        sums[i % 3] += static_cast<double>(film.radiance[i]);
    const double pixels = static_cast<double>(film.radiance.size()) / 3;
    CHECK(sums[0] / pixels == doctest::Approx(0.75).epsilon(0.005));
    CHECK(sums[1] / pixels == doctest::Approx(0.375).epsilon(0.005));
    CHECK(sums[2] == 0);

    // Direct light through the screen: depth 2, the screen costs nothing.
    const auto floor_light = [&](double opacity) {
        SceneMaker m;
        m.path().max_depth = 2;
        m.camera().look_from = {0, 1, 5};
        m.object(XzRectShape{{-5, -5}, {5, 5}, 0}, m.lambertian(0.8));
        m.object(XzRectShape{{-1, -1}, {1, 1}, 4}, m.light(5)).inside_out = true;
        Material veil;
        veil.opacity = opacity;
        veil.color.color = Double3(0);
        m.object(XzRectShape{{-9, -9}, {9, 9}, 3}, m.material(veil));
        return mean(render(m.scene, 64));
    };
    CHECK(floor_light(0.4) == doctest::Approx(0.6 * floor_light(0)).epsilon(0.01));
}
