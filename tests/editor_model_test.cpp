// What is done to a model as a whole: where it may stand.
#include "support/meshes.h"

#include <teapath/editor/model_edits.h>
#include <teapath/scene/validate.h>

#include <doctest/doctest.h>

#include <algorithm>

using namespace tp;

namespace {

// A model of one box, and a ball that is not of it.
Scene scene_with_model() {
    auto content = std::make_shared<ModelContent>();
    Object box;
    box.id = {1};
    box.name = "box";
    box.shape = MeshShape{{"box.ply#0", share(test::box_mesh())}, {}};
    box.part = {{}, "box"};
    content->objects = {box};
    Model model;
    model.id = {7};
    model.name = "box";
    model.path = "box.ply";
    model.content = content;
    Scene scene;
    scene.models.edit().push_back(model);
    box.part.model = model.id;
    Object ball;
    ball.id = {2};
    ball.shape = SphereShape{};
    scene.objects = {box, ball};
    return scene;
}

bool is_fit(const Scene& scene) {
    const std::vector<Problem> problems = validate(scene);
    return std::none_of(problems.begin(), problems.end(), [](const Problem& p) { return p.fatal; });
}

}  // namespace

TEST_CASE("a model is refused exactly where its objects could not stand") {
    const Scene scene = scene_with_model();
    const ModelId id{7};
    REQUIRE(is_fit(scene));
    Transform t;
    for (const double x : {0.0, 1e3, -1e9, 1e30, -1e30})
        for (const double scale : {1.0, -2.0, 1e9, 1e-30}) {
            t.translation = {x, 0, 0};
            t.scale = {scale, scale, scale};
            Scene placed = scene;
            place_model(placed, id, t);
            INFO("x ", x, ", scale ", scale);
            CHECK(refusal_of_place(scene, id, t).empty() == is_fit(placed));
        }
    t = {};
    t.scale.y = 0;
    CHECK(refusal_of_place(scene, id, t) == "a scale is 0");
    t = {};
    t.translation = {1e30, 0, 0};
    CHECK_FALSE(refusal_of_place(scene, id, t).empty());
}
