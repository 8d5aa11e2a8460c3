// Presets of materials and skies, colours of black bodies, and what an edit may not do.
#include <teapath/core/color.h>
#include <teapath/editor/material_presets.h>
#include <teapath/editor/refusal.h>
#include <teapath/editor/scene_edits.h>
#include <teapath/scene/validate.h>

#include <doctest/doctest.h>

#include <set>

using namespace tp;

TEST_CASE("presets: every material and sky may be in a scene, without a warning") {
    std::set<std::string> names;
    for (const MaterialPreset& preset : material_presets()) {
        CAPTURE(preset.material.name);
        CHECK(names.insert(preset.material.name).second);
        Scene scene;
        scene.cameras.resize(1);
        const MaterialId id = add_material(scene, preset.material);
        CHECK(validate(scene).empty());
        CHECK(find(scene, id)->name == preset.material.name);
    }
    CHECK(names.size() >= 12);
    for (const SkyPreset& preset : sky_presets())
        CHECK(refusal(std::vector{preset.background}).empty());
}

TEST_CASE("presets: a preset keeps the material's id and name") {
    Material mine;
    mine.id = {7};
    mine.name = "mine";
    const Material changed = with_preset(mine, material_presets().front());
    CHECK(changed.id == mine.id);
    CHECK(changed.name == mine.name);
    CHECK(changed.kind == MaterialKind::Metal);
}

TEST_CASE("black body: luminance 1, red when cool, blue when hot, and back to its temperature") {
    for (double kelvin = 1700; kelvin < 24000; kelvin *= 1.2) {
        CAPTURE(kelvin);
        const Double3 c = black_body_color(kelvin);
        CHECK(0.2126390 * c.x + 0.7151687 * c.y + 0.0721923 * c.z == doctest::Approx(1));
        REQUIRE(temperature_of(c * 5.0).has_value());
        CHECK(*temperature_of(c * 5.0) == doctest::Approx(kelvin).epsilon(0.01));
    }
    CHECK(black_body_color(2700).x > 2 * black_body_color(2700).z);
    CHECK(black_body_color(12000).z > black_body_color(12000).x);
    // Close to white where daylight is.
    const Double3 day = black_body_color(6500);
    CHECK(day.x == doctest::Approx(1).epsilon(0.1));
    CHECK(day.z == doctest::Approx(1).epsilon(0.1));
    CHECK(!temperature_of({0, 1, 0}).has_value());
    CHECK(!temperature_of({0, 0, 0}).has_value());
}

TEST_CASE("refusal: what a scene may not hold is refused, what it may is not") {
    Object object;
    object.shape = SphereShape{};
    object.material = {99};  // references are not looked at
    CHECK(refusal(std::vector{object}).empty());
    object.transform.scale.y = 0;
    CHECK(!refusal(std::vector{object}).empty());
    object.transform.scale.y = 1;
    object.shape = XzRectShape{{1, 0}, {0, 1}, 0};
    CHECK(!refusal(std::vector{object}).empty());

    Camera camera;
    CHECK(refusal(std::vector{camera}).empty());
    camera.look_at = camera.look_from;
    CHECK(!refusal(std::vector{camera}).empty());

    Material material;
    material.color.texture = {5};
    CHECK(refusal(std::vector{material}).empty());
    material.opacity = 2;
    CHECK(!refusal(std::vector{material}).empty());

    Generator generator;
    CHECK(refusal(std::vector{generator}).empty());
    generator.grid.metal = 0.9;
    CHECK(!refusal(std::vector{generator}).empty());

    RenderSettings render;
    CHECK(refusal(std::vector{render}).empty());
    render.samples = 0;
    CHECK(!refusal(std::vector{render}).empty());
    CHECK(refusal(std::vector{Texture{}}).empty());
    CHECK(refusal(std::vector{DisplaySettings{}}).empty());
}
