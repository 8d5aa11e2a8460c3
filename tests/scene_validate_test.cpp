// Checks of scenes made in memory: each problem names its place in the JSON, and says how to mend
// it.
#include <teapath/scene/texture_uses.h>
#include <teapath/scene/validate.h>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <limits>

using namespace tp;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

// A scene without problems: a camera, a texture, a material and an object of each kind of shape.
Scene good_scene() {
    Scene scene;
    Camera camera;
    camera.id = {1};
    camera.name = "main";
    scene.cameras = {camera};
    Texture checks;
    checks.id = {1};
    checks.name = "checks";
    checks.kind = TextureKind::Checker;
    scene.textures = {checks};
    Material paint;
    paint.id = {1};
    paint.name = "paint";
    paint.color.texture = {1};
    scene.materials = {paint};
    const std::vector<Shape> shapes = {SphereShape{}, XyRectShape{},    XzRectShape{},
                                       YzRectShape{}, RectangleShape{}, BoxShape{},
                                       DiskShape{},   TriangleShape{}};
    for (const Shape& shape : shapes) {
        Object object;
        object.id = {static_cast<uint32_t>(scene.objects.size()) + 1};
        object.shape = shape;
        object.material = {1};
        scene.objects.edit().push_back(object);
    }
    return scene;
}

// The one problem of a good scene that `change` has spoilt.
void check_problem(bool fatal, const std::string& where, const std::string& what,
                   const std::function<void(Scene&)>& change) {
    CAPTURE(where);
    CAPTURE(what);
    Scene scene = good_scene();
    change(scene);
    const std::vector<Problem> problems = validate(scene);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].fatal == fatal);
    CHECK(problems[0].where == where);
    CAPTURE(problems[0].what);
    CHECK(problems[0].what.find(what) != std::string::npos);
    if (fatal) CHECK(!problems[0].remedy.empty());
}

void check_fatal(const std::string& where, const std::string& what,
                 const std::function<void(Scene&)>& change) {
    check_problem(true, where, what, change);
}
void check_warning(const std::string& where, const std::string& what,
                   const std::function<void(Scene&)>& change) {
    check_problem(false, where, what, change);
}

}  // namespace

TEST_CASE("validate: a good scene has no problem, nor has an empty one") {
    CHECK(validate(good_scene()).empty());
    CHECK(validate(Scene{}).empty());
}

TEST_CASE("validate: sizes and settings") {
    for (const int size : {0, -1, 65537, 100000}) {
        check_fatal("render.width", "out of range", [=](Scene& s) { s.render.width = size; });
        check_fatal("render.height", "out of range", [=](Scene& s) { s.render.height = size; });
    }
    check_fatal("render", "60000 x 60000 pixels are too many",
                [](Scene& s) { s.render.width = s.render.height = 60000; });
    check_fatal("render.samples", "out of range", [](Scene& s) { s.render.samples = 0; });
    check_fatal("render.max_depth", "out of range", [](Scene& s) { s.render.path.max_depth = 0; });
    check_fatal("render.tea_rounds", "out of range",
                [](Scene& s) { s.render.path.tea_rounds = 5; });
    check_fatal("render.key_rounds", "out of range",
                [](Scene& s) { s.render.path.key_rounds = 33; });
    check_fatal("display.exposure", "out of range",
                [](Scene& s) { s.display.exposure = static_cast<float>(kNan); });
}

TEST_CASE("validate: cameras") {
    for (const double fov : {0.0, 180.0, -5.0, 1000.0, kNan, kInf})
        check_fatal("camera.vertical_fov", "no field of view",
                    [=](Scene& s) { s.cameras[0].vertical_fov = fov; });
    check_fatal("camera.look_at", "looks at where it is",
                [](Scene& s) { s.cameras[0].look_at = s.cameras[0].look_from; });
    check_fatal("camera.up", "parallel to the view",
                [](Scene& s) { s.cameras[0].up = s.cameras[0].look_from * -3.0; });
    check_fatal("camera.up", "no direction", [](Scene& s) { s.cameras[0].up = Double3(0); });
    check_fatal("camera.look_from[2]", "not finite",
                [](Scene& s) { s.cameras[0].look_from.z = kNan; });
    check_fatal("camera.look_from[0]", "too large",
                [](Scene& s) { s.cameras[0].look_from.x = 1e16; });
    check_fatal("camera.aperture", "negative", [](Scene& s) { s.cameras[0].aperture = -1; });
    check_fatal("camera.focus_distance", "negative",
                [](Scene& s) { s.cameras[0].focus_distance = -1; });
    check_fatal("camera.near_clip", "not finite", [](Scene& s) { s.cameras[0].near_clip = kInf; });
    check_fatal("camera.far_clip", "not beyond the near one", [](Scene& s) {
        s.cameras[0].near_clip = 2;
        s.cameras[0].far_clip = 1;
    });
    check_fatal("cameras[1].vertical_fov", "no field of view", [](Scene& s) {
        s.cameras.push_back(s.cameras[0]);
        s.cameras[1].name = "other";
        s.cameras[1].vertical_fov = 0;
    });
    check_fatal("cameras", "\"main\" is used twice",
                [](Scene& s) { s.cameras.push_back(s.cameras[0]); });
    check_fatal("active_camera", "does not exist", [](Scene& s) { s.active_camera = {7}; });
}

TEST_CASE("validate: the background") {
    check_fatal("background.top[1]", "not finite", [](Scene& s) { s.background.top.y = kNan; });
    check_fatal("background.color", "negative", [](Scene& s) { s.background.color = {-1, 0, 0}; });
    check_fatal("background.strength", "negative", [](Scene& s) { s.background.strength = -1; });
    check_fatal("background", "a radiance of 1e+15 is too much", [](Scene& s) {
        s.background.kind = BackgroundKind::Constant;
        s.background.color = Double3(1e12);
        s.background.strength = 1e3;
    });
    check_fatal("background.rotation", "not finite",
                [](Scene& s) { s.background.rotation = kInf; });
}

TEST_CASE("validate: materials and textures") {
    const auto metal = [](Scene& s, double fuzz) {
        s.materials.edit()[0].kind = MaterialKind::Metal;
        s.materials.edit()[0].fuzz = fuzz;
    };
    for (const double fuzz : {-0.1, 1.1, kNan})
        check_fatal("materials.paint.fuzz", "out of range", [=](Scene& s) { metal(s, fuzz); });
    for (const double ior : {0.0, -1.0, 1e9, kNan})
        check_fatal("materials.paint.ior", "out of range", [=](Scene& s) {
            s.materials.edit()[0].kind = MaterialKind::Dielectric;
            s.materials.edit()[0].ior = ior;
        });
    const auto principled = [](Scene& s) -> Material& {
        s.materials.edit()[0].kind = MaterialKind::Principled;
        return s.materials.edit()[0];
    };
    for (const double share : {-0.1, 1.1, kNan}) {
        check_fatal("materials.paint.metallic", "out of range",
                    [=](Scene& s) { principled(s).surface.metallic.value = share; });
        check_fatal("materials.paint.coat_roughness", "out of range",
                    [=](Scene& s) { principled(s).surface.coat_roughness.value = share; });
    }
    check_fatal("materials.paint.ior", "out of range", [=](Scene& s) { principled(s).ior = 0.9; });
    check_fatal("materials.paint.normal", "does not exist",
                [=](Scene& s) { principled(s).surface.normal = {77}; });
    check_fatal("materials.paint.sheen_color", "does not exist",
                [=](Scene& s) { principled(s).surface.sheen_color.texture = {77}; });
    check_fatal("materials.paint.attenuation_distance", "negative",
                [=](Scene& s) { principled(s).surface.attenuation_distance = -1; });
    for (const double opacity : {-0.1, 1.1, kNan})
        check_fatal("materials.paint.opacity", "out of range",
                    [=](Scene& s) { s.materials.edit()[0].opacity = opacity; });
    check_fatal("materials.paint.strength", "negative", [](Scene& s) {
        s.materials.edit()[0].emits = true;
        s.materials.edit()[0].strength = -1;
    });
    check_fatal("materials.paint.emission", "a radiance of 1e+15 is too much", [](Scene& s) {
        s.materials.edit()[0].emits = true;
        s.materials.edit()[0].emission.color = {1, 1, 1e14};
        s.materials.edit()[0].strength = 10;
    });
    check_fatal("materials.paint.color", "negative", [](Scene& s) {
        s.materials.edit()[0].color = {{-1, 0, 0}, {}};
    });
    check_fatal("materials.paint.color", "does not exist",
                [](Scene& s) { s.materials.edit()[0].color.texture = {9}; });
    check_fatal("textures.checks.odd", "does not exist",
                [](Scene& s) { s.textures.edit()[0].odd.texture = {9}; });
    check_fatal("textures.checks.cells[0]", "not finite",
                [](Scene& s) { s.textures.edit()[0].cells.x = kNan; });
    check_warning("materials.paint.color", "more light than it gets", [](Scene& s) {
        s.materials.edit()[0].color = {{1.5, 0, 0}, {}};
    });
    check_fatal("materials", "\"paint\" is used twice", [](Scene& s) {
        s.materials.edit().push_back(s.materials[0]);
        s.materials.edit()[1].id = {2};
    });
    // What has no name is called by where it is used.
    check_fatal("objects[3].material.fuzz", "out of range", [&](Scene& s) {
        Material inline_metal;
        inline_metal.id = {2};
        inline_metal.kind = MaterialKind::Metal;
        inline_metal.fuzz = 2;
        s.materials.edit().push_back(inline_metal);
        s.objects.edit()[3].material = {2};
    });
    check_fatal("materials.paint.color.even", "negative", [](Scene& s) {
        s.textures.edit()[0].name.clear();
        s.textures.edit()[0].even.color = Double3(-1);
    });
}

TEST_CASE("validate: the numbers of patterns, triplanar images and bump maps") {
    const auto pattern = [](TextureKind kind, auto change) {
        return [=](Scene& s) {
            Texture& t = s.textures.edit()[0];
            t.kind = kind;
            change(t);
        };
    };
    check_fatal("textures.checks.scale[1]", "not finite",
                pattern(TextureKind::Noise, [](Texture& t) { t.scale.y = kNan; }));
    check_fatal("textures.checks.octaves", "out of range",
                pattern(TextureKind::Noise, [](Texture& t) { t.octaves = 17; }));
    check_fatal("textures.checks.tea_rounds", "out of range",
                pattern(TextureKind::Marble, [](Texture& t) { t.tea_rounds = 1; }));
    check_fatal("textures.checks.seed", "out of range",
                pattern(TextureKind::Wood, [](Texture& t) { t.seed = -1; }));
    check_fatal("textures.checks.vein_power", "out of range",
                pattern(TextureKind::Marble, [](Texture& t) { t.vein_power = 0; }));
    check_fatal("textures.checks.late", "negative",
                pattern(TextureKind::Wood, [](Texture& t) { t.late.color = Double3(-1); }));
    check_fatal("textures.checks.vein", "does not exist",
                pattern(TextureKind::Marble, [](Texture& t) { t.vein.texture = {9}; }));
    check_fatal("textures.checks.brick_size[0]", "out of range",
                pattern(TextureKind::Brick, [](Texture& t) { t.brick_size.x = 0; }));
    check_fatal("textures.checks.sharpness", "out of range",
                pattern(TextureKind::Image, [](Texture& t) { t.sharpness = 0; }));
    check_fatal("textures.checks.space", "no texture coordinates",
                pattern(TextureKind::Image, [](Texture& t) {
                    t.projection = TextureProjection::Triplanar;
                    t.space = TextureSpace::Uv;
                }));
    const auto bump = [](TextureId texture, double scale) {
        return [=](Scene& s) {
            Material& m = s.materials.edit()[0];
            m.kind = MaterialKind::Principled;
            m.surface.bump = texture;
            m.surface.bump_scale = scale;
        };
    };
    check_fatal("materials.paint.bump", "does not exist", bump({9}, 1));
    check_fatal("materials.paint.bump_scale", "not finite", bump({1}, kNan));
}

TEST_CASE("validate: textures of two colours nest four levels deep, in checkers too") {
    // Each holds the next; the kinds in turn.
    const auto chain = [](std::initializer_list<TextureKind> kinds, uint32_t last) {
        Scene s = good_scene();
        s.textures.edit().clear();
        uint32_t id = 0;
        for (const TextureKind kind : kinds) {
            Texture t;
            t.id = {++id};
            t.name = fmt::format("t{}", id);
            t.kind = kind;
            const TextureId next{id < kinds.size() ? id + 1 : last};
            t.even.texture = t.low.texture = t.vein.texture = t.early.texture = t.brick.texture =
                next;
            s.textures.edit().push_back(t);
        }
        return s;
    };
    using K = TextureKind;
    CHECK(validate(chain({K::Noise, K::Marble, K::Wood, K::Brick}, 0)).empty());
    CHECK(validate(chain({K::Checker, K::Noise, K::Checker, K::Wood, K::Brick}, 0)).empty());
    const std::vector<Problem> deep =
        validate(chain({K::Noise, K::Noise, K::Marble, K::Checker, K::Wood, K::Brick}, 0));
    REQUIRE(deep.size() == 1);
    CHECK(deep[0].where == "textures.t1");
    CHECK(deep[0].what == "the textures that mix colours nest too deeply");
    for (const uint32_t start : {1u, 3u}) {
        const std::vector<Problem> circle =
            validate(chain({K::Noise, K::Checker, K::Brick, K::Wood}, start));
        REQUIRE(circle.size() == 1);
        CHECK(circle[0].what == "the texture contains itself");
        CHECK(circle[0].where >= fmt::format("textures.t{}", start));
    }
    // What a texture of another kind would hold is no circle yet, but the menus look at it.
    Scene other = chain({K::Noise, K::Constant}, 1);
    CHECK(validate(other).empty());
    CHECK(holds(other, {1}, {2}));
    CHECK(holds(other, {2}, {1}));
    CHECK_FALSE(holds(chain({K::Noise, K::Constant}, 0), {2}, {1}));
}

TEST_CASE("validate: checkers may share and nest, but not turn in a circle") {
    const auto chain = [](uint32_t length, uint32_t last) {
        Scene s = good_scene();
        s.textures.edit().clear();
        for (uint32_t i = 1; i <= length; ++i) {
            Texture t;
            t.id = {i};
            t.name = fmt::format("t{}", i);
            t.kind = TextureKind::Checker;
            t.even.texture = t.odd.texture = {i < length ? i + 1 : last};
            s.textures.edit().push_back(t);
        }
        return s;
    };
    CHECK(validate(chain(64, 0)).empty());
    REQUIRE(validate(chain(65, 0)).size() == 1);
    CHECK(validate(chain(65, 0))[0].where == "textures.t1");
    CHECK(validate(chain(65, 0))[0].what == "the textures nest too deeply");
    CHECK(validate(chain(20000, 0)).size() == 1);
    for (const uint32_t start : {1u, 5u, 9u}) {
        const std::vector<Problem> problems = validate(chain(9, start));
        REQUIRE(problems.size() == 1);
        CHECK(problems[0].what == "the texture contains itself");
        CHECK(problems[0].where >= fmt::format("textures.t{}", start));
    }
    CHECK(validate(chain(20000, 10000)).size() == 1);
}

TEST_CASE("validate: objects and their placement") {
    check_fatal("objects[0].material", "does not exist",
                [](Scene& s) { s.objects.edit()[0].material = {5}; });
    check_fatal("objects[2].transform.scale", "leaves nothing",
                [](Scene& s) { s.objects.edit()[2].transform.scale.y = 0; });
    check_fatal("objects[2].transform.scale", "too small",
                [](Scene& s) { s.objects.edit()[2].transform.scale.y = 1e-30; });
    check_fatal("objects[0]", "reaches too far", [](Scene& s) {
        s.objects.edit()[0].shape = SphereShape{{0, 0, 0}, 1e10};
        s.objects.edit()[0].transform.scale = Double3(1e10);
    });
    check_fatal("objects[0].shape.radius", "too small", [](Scene& s) {
        s.objects.edit()[0].shape = SphereShape{{0, 0, 0}, 1e-10};
        s.objects.edit()[0].transform.scale = Double3(1e-10);
    });
    check_fatal("objects[2].transform.rotate[1]", "not finite",
                [](Scene& s) { s.objects.edit()[2].transform.rotation.y = kNan; });
    check_fatal("objects[2].transform.translate[1]", "too large",
                [](Scene& s) { s.objects.edit()[2].transform.translation.y = -1e30; });
}

TEST_CASE("validate: shapes without a size are never hit, shapes that cannot be are refused") {
    const auto shape = [](size_t index, auto value) {
        return [=](Scene& s) { s.objects.edit()[index].shape = value; };
    };
    check_warning("objects[0].shape.radius", "radius 0: it is never hit",
                  shape(0, SphereShape{{0, 0, 0}, 0}));
    check_fatal("objects[0].shape.radius", "too small", shape(0, SphereShape{{0, 0, 0}, 1e-20}));
    check_fatal("objects[0].shape.radius", "not finite", shape(0, SphereShape{{0, 0, 0}, kInf}));
    check_warning("objects[1].shape", "the rectangle has no area: it is never hit",
                  shape(1, XyRectShape{{1, 0}, {1, 1}, 0}));
    check_fatal("objects[2].shape.low", "above the high one",
                shape(2, XzRectShape{{2, 0}, {1, 1}, 0}));
    check_fatal("objects[3].shape.k", "not finite", shape(3, YzRectShape{{0, 0}, {1, 1}, kNan}));
    check_warning("objects[4].shape", "the rectangle has no area",
                  shape(4, RectangleShape{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}));
    check_warning("objects[5].shape", "the box has no volume",
                  shape(5, BoxShape{{0, 0, 0}, {1, 0, 1}}));
    check_fatal("objects[5].shape.low", "above the high one",
                shape(5, BoxShape{{0, 2, 0}, {1, 1, 1}}));
    check_fatal("objects[6].shape.normal", "no direction", shape(6, DiskShape{{}, Double3(0), 1}));
    check_warning("objects[6].shape.radius", "radius 0", shape(6, DiskShape{{}, {0, 1, 0}, 0}));
    check_fatal("objects[6].shape.radius", "negative", shape(6, DiskShape{{}, {0, 1, 0}, -1}));
    check_warning("objects[7].shape", "the triangle has no area",
                  shape(7, TriangleShape{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}));
    CHECK(validate([] {
              Scene s = good_scene();
              s.objects.edit()[0].shape = SphereShape{{0, 0, 0}, -1};
              return s;
          }())
              .empty());
}

TEST_CASE("validate: generators") {
    const auto grid = [](auto change) {
        return [=](Scene& s) {
            s.generators.edit().resize(1);
            change(s.generators.edit()[0].grid);
        };
    };
    check_fatal("generate[0].columns", "out of range", grid([](SphereGrid& g) { g.columns = -1; }));
    check_fatal("generate[0].lambertian", "out of range",
                grid([](SphereGrid& g) { g.lambertian = 1.5; }));
    check_fatal("generate[0].metal", "add up to more than 1",
                grid([](SphereGrid& g) { g.metal = 0.5; }));
    check_fatal("generate[0].ior", "out of range", grid([](SphereGrid& g) { g.ior = 0; }));
    check_fatal("generate[0].radius", "negative", grid([](SphereGrid& g) { g.radius = -1; }));
    check_warning("generate[0].radius", "never hit", grid([](SphereGrid& g) { g.radius = 0; }));
    check_fatal("generate[0].keep_clear[1][3]", "not finite", grid([](SphereGrid& g) {
                    g.keep_clear = {Double4(0), Double4(0, 0, 0, kNan)};
                }));
    check_fatal("generate[2]", "more than 20 million", [](Scene& s) {
        s.generators.edit().resize(4);
        for (Generator& g : s.generators.edit())
            g.grid.columns = g.grid.rows = 3000;
    });
}

TEST_CASE("validate: takes a time that is linear in what there is") {
    Scene scene = good_scene();
    for (uint32_t i = 2; i < 200000; ++i) {
        Material material;
        material.id = {i};
        scene.materials.edit().push_back(material);
        Object object;
        object.id = {100 + i};
        object.material = {i};
        scene.objects.edit().push_back(object);
    }
    const auto start = std::chrono::steady_clock::now();
    CHECK(validate(scene).empty());
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
}
