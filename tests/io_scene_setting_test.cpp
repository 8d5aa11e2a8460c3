// --set: one value by its path, everything else as it was.
#include "support/shipped_scenes.h"

#include <teapath/core/error.h>
#include <teapath/io/scene_file.h>

#include <doctest/doctest.h>

using namespace tp;

namespace {

const Scene& scene() {
    static const Scene scene = parse_scene(
        R"({"teapath": 1,
            "cameras": [{"name": "front"}, {"name": "side.view", "look_from": [5, 0, 0]}],
            "active_camera": "side.view",
            "textures": {"tiles": {"type": "checker"}},
            "materials": {"red": {"type": "lambertian", "color": [1, 0, 0]},
                          "a.b": {"type": "metal", "color": "tiles"}},
            "objects": [{"name": "ball", "shape": {"type": "sphere"}, "material": "red"},
                        {"shape": {"type": "box"}, "material": {"type": "metal"}}],
            "generate": [{"type": "sphere_grid", "name": "grid"}]})",
        ".", "test.json");
    return scene;
}

Scene set(const char* path, const char* value) {
    CAPTURE(path);
    return with_setting(scene(), path, value);
}

}  // namespace

TEST_CASE("--set: settings, words, lists and whole objects") {
    CHECK(set("render.max_depth", "3").render.path.max_depth == 3);
    CHECK(set("render.sampler", "sobol").render.path.sampler == SamplerKind::Sobol);
    CHECK(set("render.sampler", "\"sobol\"").render.path.sampler == SamplerKind::Sobol);
    CHECK(set("name", "two words").name == "two words");
    CHECK(set("display", R"({"exposure": 2})").display.exposure == 2);
    const Scene constant = set("background", R"({"type": "constant", "color": 0.25})");
    CHECK(constant.background.kind == BackgroundKind::Constant);
    CHECK(constant.background.color == Double3(0.25));
    CHECK(set("background.bottom", "[0, 0, 1]").background.bottom == Double3(0, 0, 1));
}

TEST_CASE("--set: elements by number and by name, parts of vectors that have their default") {
    CHECK_FALSE(set("objects[1].visible", "false").objects[1].visible);
    CHECK_FALSE(set("objects.1.visible", "false").objects[1].visible);
    CHECK_FALSE(set("objects.ball.visible", "false").objects[0].visible);
    CHECK(set("objects[1].transform.scale[2]", "3").objects[1].transform.scale == Double3(1, 1, 3));
    CHECK(std::get<SphereShape>(set("objects.ball.shape.radius", "2").objects[0].shape).radius ==
          2);
    CHECK(set("materials.a.b.fuzz", "0.5").materials[1].fuzz == 0.5);
    CHECK(set("materials.red.color[1]", "0.5").materials[0].color.color == Double3(1, 0.5, 0));
    CHECK(set("materials.red.color", "tiles").materials[0].color.texture == TextureId{1});
    CHECK(set("generate.grid.seed", "7").generators[0].grid.seed == 7);
    CHECK(set("textures.tiles.cells", "[2, 2]").textures[0].cells == Double2(2));
}

TEST_CASE("--set: camera is the active one, cameras are a list even of one") {
    CHECK(set("camera.aperture", "0.5").cameras[1].aperture == 0.5);
    CHECK(set("camera.aperture", "0.5").cameras[0].aperture == 0);
    CHECK(set("cameras.front.aperture", "0.5").cameras[0].aperture == 0.5);
    CHECK(set("cameras.side.view.aperture", "1").cameras[1].aperture == 1);
    CHECK(active_camera(set("active_camera", "front")).name == "front");
    const Scene one = parse_scene(R"({"teapath": 1})", ".", "test.json");
    CHECK(with_setting(one, "cameras[0].aperture", "0.5").cameras[0].aperture == 0.5);
    CHECK(with_setting(one, "camera.look_from.0", "3").cameras[0].look_from == Double3(3, 1, 4));
}

TEST_CASE("--set: everything else stays, images too") {
    Scene changed = set("render.samples", "5");
    changed.render.samples = scene().render.samples;
    CHECK(changed == scene());
    const Scene logo = load_scene(test::scene_folder() / "thesis" / "logo.json");
    const Scene dark = with_setting(logo, "objects[1].visible", "false");
    REQUIRE(dark.textures.size() == logo.textures.size());
    for (size_t i = 0; i < logo.textures.size(); ++i)
        CHECK(dark.textures[i].file.image == logo.textures[i].file.image);
    const Scene other = with_setting(logo, "textures.logo.file", "../../assets/textures/globe.png");
    REQUIRE(other.textures[0].file.image);
    CHECK(other.textures[0].file.image->width != logo.textures[0].file.image->width);
}

TEST_CASE("--set: mistakes are named, with the nearest name") {
    const auto fails = [](const char* path, const char* value, const char* part) {
        CAPTURE(path);
        try {
            with_setting(scene(), path, value);
            FAIL_CHECK("no error");
        } catch (const Error& error) {
            const std::string message = error.what();
            CAPTURE(message);
            CHECK(error.exit_code() == 2);
            CHECK(message.find(std::string("--set ") + path) == 0);
            CHECK(message.find(part) != std::string::npos);
        }
    };
    fails("render.max_dept", "3", "did you mean \"max_depth\"?");
    fails("rendr.max_depth", "3", "did you mean \"render\"?");
    fails("render.width", "wide", "expected a number, found a string");
    fails("render.width", "0", "out of range");
    fails("camera.vertical_fov", "1e400", "1e400 is too large");
    fails("camera.vertical_fov", "NaN", "expected a number");
    fails("render.width.x", "0", "goes on behind a plain value");
    fails("render..width", "0", "empty part");
    fails("render.", "0", "empty part");
    fails("", "0", "empty part");
    fails("objects[2].visible", "true", "the list has 2 elements");
    fails("objects[-1].visible", "true", "there is no element \"-1\"");
    fails("objects[1.visible", "true", "a bracket is not closed");
    fails("objects.bal.visible", "true", "did you mean \"ball\"?");
    fails("objects[0].material", "blue", "unknown material \"blue\"");
    fails("active_camera", "frnt", "did you mean \"front\"?");
    fails("materials.red.fuzz", "1", "unknown key \"fuzz\"");
}
