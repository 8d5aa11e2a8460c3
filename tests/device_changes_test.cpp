// What a change of the scene asks to be made anew, and what it leaves alone.
#include "support/scene_maker.h"

#include <teapath/device/scene_arrays.h>

using namespace tp;
using namespace tp::test;

namespace {

// One of each thing that has a name.
Scene named_scene() {
    SceneMaker maker;
    maker.sphere({0, 0, 0}, 1, maker.lambertian(0.5));
    maker.texture({});
    maker.scene.generators.edit().resize(1);
    maker.scene.generators.edit()[0].id = {1};
    maker.scene.generators.edit()[0].grid.columns = maker.scene.generators.edit()[0].grid.rows = 2;
    return maker.scene;
}

SceneParts parts_of(const std::function<void(Scene&)>& change) {
    Scene changed = named_scene();
    change(changed);
    return changed_parts(named_scene(), changed);
}

void rename_all(Scene& s) {
    s.objects.edit()[0].name = "a ball";
    s.generators.edit()[0].name = "a grid";
    s.materials.edit()[0].name = "a paint";
    s.textures.edit()[0].name = "a picture";
    s.cameras[0].name = "a camera";
    s.name = "a scene";
}

}  // namespace

TEST_CASE("changes: names are no part of the image, alone or beside what is") {
    CHECK(parts_of(rename_all) == SceneParts::None);
    const std::function<void(Scene&)> changes[] = {
        [](Scene& s) { s.objects.edit()[0].visible = false; },
        [](Scene& s) { s.generators.edit()[0].grid.seed = 1; },
        [](Scene& s) { s.materials.edit()[0].fuzz = 0.5; },
        [](Scene& s) {
            s.textures.edit()[0].repeat = {2, 2};
        },
        [](Scene& s) { s.cameras[0].vertical_fov = 50; },
        [](Scene& s) { s.objects.edit().clear(); },
    };
    for (const auto& change : changes) {
        CHECK(parts_of(change) != SceneParts::None);
        CHECK(parts_of([&](Scene& s) {
                  rename_all(s);
                  change(s);
              }) == parts_of(change));
    }
}

TEST_CASE("changes: a film goes on when something gets another name") {
    Session session(session_options());
    Scene scene = named_scene();
    session.sync(std::make_shared<const Scene>(scene));
    REQUIRE(session.step(2));
    rename_all(scene);
    session.sync(std::make_shared<const Scene>(scene));
    CHECK(session.samples() == 2);
    scene.materials.edit()[0].color.color = {1, 0, 0};
    session.sync(std::make_shared<const Scene>(scene));
    CHECK(session.samples() == 0);
}
