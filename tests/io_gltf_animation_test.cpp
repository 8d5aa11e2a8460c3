// Animations of glTF files: what is read, and the scene as it stands at a time.
#include "support/animated_gltf.h"

#include <teapath/io/scene_file.h>
#include <teapath/render/session.h>
#include <teapath/scene/pose.h>
#include <teapath/scene/validate.h>

#include <algorithm>
#include <cmath>

using namespace tp;
using namespace tp::test;

namespace {

std::filesystem::path write_animated(const ModelFolder& folder, const std::string& more = "") {
    return folder.write("a.gltf",
                        "{\"asset\": {\"version\": \"2.0\"}, " + animated_json(more) + "}");
}

const Object& named(const Scene& scene, const std::string& path) {
    const auto found = std::find_if(scene.objects.begin(), scene.objects.end(),
                                    [&](const Object& o) { return o.part.path == path; });
    REQUIRE(found != scene.objects.end());
    return *found;
}

std::shared_ptr<const Scene> at(Scene scene, double seconds) {
    scene.render.time = seconds;
    return ScenePoser().pose(std::make_shared<const Scene>(std::move(scene)));
}

// The n-th vertex of an object in the world.
Double3 vertex(const Scene& scene, const std::string& path, size_t n) {
    const Object& object = named(scene, path);
    return Double3(placed(object) * Double4(Double3(mesh_of(object).positions[n]), 1));
}

bool is_near(Double3 a, Double3 b) {
    return glm::length(a - b) < 1e-4;
}

Object& edited(Scene& scene, const std::string& path) {
    for (Object& object : scene.objects.edit())
        if (object.part.path == path) return object;
    throw "no such part";
}

}  // namespace

TEST_CASE("gltf animation: names, lengths and samplers are those of the file") {
    const ModelFolder folder;
    const Scene scene = load_scene(write_animated(folder));
    const Model& model = scene.models[0];
    REQUIRE(model.content->motion);
    const auto& animations = model.content->motion->animations;
    REQUIRE(animations.size() == 4);
    CHECK(animations[0].name == "slide");
    CHECK(animations[0].length == 2);
    CHECK(animations[1].samplers[0].interpolation == Interpolation::CubicSpline);
    CHECK(animations[2].samplers[0].values == std::vector<float>{0, 1});
    CHECK(animation_length(scene) == 2);
    CHECK(model.content->unsupported.empty());
}

TEST_CASE("gltf animation: nodes, targets and joints stand where the keyframes say") {
    const ModelFolder folder;
    const Scene scene = load_scene(write_animated(folder));
    const auto start = at(scene, 0), middle = at(scene, 0.5), end = at(scene, 5);
    CHECK(is_near(vertex(*start, "mover", 0), {0, 0, 0}));
    CHECK(is_near(vertex(*middle, "mover", 0), {1, 0, 0}));
    CHECK(is_near(vertex(*end, "mover", 1), {5, 0, 0}));
    // Its child goes along and turns: x becomes y.
    CHECK(is_near(vertex(*start, "mover/turner", 1), {1, 1, 0}));
    CHECK(is_near(vertex(*end, "mover/turner", 1), {4, 2, 0}));
    const double half = std::sqrt(0.5);
    CHECK(is_near(vertex(*middle, "mover/turner", 1), {1 + half, 1 + half, 0}));
    CHECK(is_near(vertex(*middle, "morpher", 1), {1, 0, 5.5}));
    CHECK(is_near(vertex(*end, "morpher", 2), {0, 1, 6}));
    // One vertex of each joint, one between them; the step comes at second 1.
    CHECK(is_near(vertex(*middle, "skinned", 2), {0, 1, 0}));
    CHECK(is_near(vertex(*end, "skinned", 0), {0, 0, 0}));
    CHECK(is_near(vertex(*end, "skinned", 1), {1, 3, 0}));
    CHECK(is_near(vertex(*end, "skinned", 2), {0, 2.5, 0}));
}

TEST_CASE("gltf animation: one by its name, or none") {
    const ModelFolder folder;
    Scene scene = load_scene(write_animated(folder));
    scene.models.edit()[0].animation = "spin";
    CHECK(animation_length(scene) == 1);
    CHECK(is_near(vertex(*at(scene, 5), "mover", 0), {0, 0, 0}));
    CHECK(is_near(vertex(*at(scene, 5), "mover/turner", 1), {0, 2, 0}));
    scene.models.edit()[0].animation = "none";
    const auto still = std::make_shared<const Scene>(scene);
    CHECK(ScenePoser().pose(still) == still);
    CHECK(validate(scene).empty());
    scene.models.edit()[0].animation = "dance";
    const auto problems = validate(scene);
    REQUIRE(problems.size() == 1);
    CHECK_FALSE(problems[0].fatal);
}

TEST_CASE("gltf animation: changes stay with their parts, and models keep their place") {
    const ModelFolder folder;
    Scene scene = load_scene(write_animated(folder));
    // In the part's own space: a child at the end of its own x.
    Object& turner = edited(scene, "mover/turner");
    turner.transform.translation.x += 2;
    CHECK(is_near(vertex(*at(scene, 0), "mover/turner", 0), {2, 1, 0}));
    CHECK(is_near(vertex(*at(scene, 5), "mover/turner", 0), {4, 3, 0}));

    scene.render.time = 5;
    PoseChanges late(scene);
    const auto change = late.of(named(scene, "mover"));
    REQUIRE(change);
    CHECK(is_near(Double3((*change)[3]), {4, 0, 0}));

    Model model = load_model(write_animated(folder));
    model.transform.scale = Double3(10);
    Scene large;
    add_model(large, model);
    CHECK(is_near(vertex(*at(large, 5), "mover", 1), {50, 0, 0}));
    CHECK(is_near(vertex(*at(large, 5), "skinned", 1), {10, 30, 0}));
}

TEST_CASE("gltf animation: only meshes that change their form are made anew") {
    const ModelFolder folder;
    const Scene scene = load_scene(write_animated(folder));
    ScenePoser poser;
    const auto pose = [&](double seconds) {
        Scene copy = scene;
        copy.render.time = seconds;
        return poser.pose(std::make_shared<const Scene>(copy));
    };
    const auto mesh = [](const Scene& s, const char* path) {
        return std::get<MeshShape>(named(s, path).shape).file.mesh;
    };
    const auto a = pose(0.25), b = pose(0.5);
    CHECK(mesh(*a, "mover") == mesh(scene, "mover"));
    CHECK(mesh(*a, "morpher") != mesh(*b, "morpher"));
    CHECK(mesh(*a, "skinned") == mesh(*b, "skinned"));  // its joints have not moved yet
    CHECK(changed_parts(*a, *b) == SceneParts::Geometry);
    CHECK(changed_parts(*b, *b) == SceneParts::None);

    // A change of something else keeps the objects as they are posed.
    Scene brighter = scene;
    brighter.render.time = 0.5;
    const auto c = poser.pose(std::make_shared<const Scene>(brighter));
    brighter.display.exposure = 1;
    brighter.cameras[0].vertical_fov = 20;
    const auto d = poser.pose(std::make_shared<const Scene>(brighter));
    CHECK(&c->objects.items() == &d->objects.items());
    CHECK(d->cameras[0].vertical_fov == 20);
    CHECK(changed_parts(*c, *d) == SceneParts::Parameters);

    SessionOptions options;
    options.backend = BackendKind::Host;
    Session session(options);
    const auto sync = [&](double seconds) {
        auto copy = std::make_shared<Scene>(scene);
        copy->render.time = seconds;
        copy->render.width = copy->render.height = 8;
        session.sync(copy);
    };
    const auto tree_of = [&](const Mesh* of) -> std::shared_ptr<const MeshArrays> {
        for (const MeshOfScene& m : session.arrays().meshes)
            if (m.source.lock().get() == of) return m.arrays;
        return nullptr;
    };
    sync(0.25);
    REQUIRE(session.step(1));
    const auto before = tree_of(mesh(scene, "mover").get());
    REQUIRE(before);
    sync(0.5);
    CHECK(session.samples() == 0);
    CHECK(tree_of(mesh(scene, "mover").get()) == before);
    // After the end nothing moves any more: the film goes on.
    sync(7);
    REQUIRE(session.step(1));
    sync(8);
    CHECK(session.samples() == 1);
    // One form at a time is held.
    CHECK(session.arrays().meshes.size() <= 4);
}

TEST_CASE("gltf animation: time and choice are kept by scene files") {
    const ModelFolder folder;
    write_animated(folder);
    const Scene first = parse_scene(
        R"({"teapath": 1, "render": {"time": 0.75}, "models": [{"file": "a.gltf", "animation": "slide",
            "objects": {"mover": {"visible": false}}}]})",
        folder.path, "s.json");
    CHECK(first.render.time == 0.75);
    CHECK(first.models[0].animation == "slide");
    const std::string text = scene_text(first);
    const Scene second = parse_scene(text, folder.path, "s.json");
    CHECK(second == first);
    CHECK(scene_text(second) == text);
    CHECK(text.find("mover/turner") == std::string::npos);  // no part counts as changed
    CHECK(scene_text(load_scene(folder.path / "a.gltf")).find("animation") == std::string::npos);
    CHECK(with_setting(first, "render.time", "1.5").render.time == 1.5);
    CHECK_THROWS(with_setting(first, "render.tme", "1.5"));
}

TEST_CASE("gltf animation: what is broken or not supported is left out with a sentence") {
    const ModelFolder folder;
    const auto sentences = [&](const std::string& channel, const std::string& sampler) {
        const Scene scene = load_scene(write_animated(
            folder, ", {\"name\": \"odd\", \"channels\": [{\"sampler\": 0, \"target\": " + channel +
                        "}], \"samplers\": [" + sampler + "]}"));
        CHECK(scene.models[0].content->motion->animations.size() == 4);
        std::string all;
        for (const std::string& sentence : scene.models[0].content->unsupported)
            all += sentence;
        return all;
    };
    const std::string good = R"({"input": 4, "output": 5})";
    const auto move = R"({"node": 0, "path": "translation"})";
    CHECK(
        says(sentences(R"({"path": "pointer", "extensions": {}})", good), "KHR_animation_pointer"));
    CHECK(sentences(R"({"path": "translation"})", good) == "");
    CHECK(sentences(R"({"node": 0, "path": "colour"})", good) ==
          "Animation \"odd\": channel 0 is left out: there is no property \"colour\".");
    CHECK(says(sentences(R"({"node": 0, "path": "colour"})", good), "\"colour\""));
    CHECK(says(sentences(R"({"node": 0, "path": "weights"})", good), "no morph targets"));
    CHECK(says(sentences(move, R"({"input": 4, "output": 99})"), "no accessor"));
    CHECK(says(sentences(move, R"({"input": 4})"), "no output"));
    CHECK(says(sentences(move, R"({"input": 4, "output": 9, "interpolation": "CUBICSPLINE"})"),
               "6 numbers for 2 keyframes"));
    CHECK(
        says(sentences(move, R"({"input": 4, "output": 5, "interpolation": "BEZIER"})"), "BEZIER"));
    CHECK(says(sentences(move, R"({"input": 5, "output": 5})"), "do not rise"));
    CHECK(says(sentences(move, "3"), "no sampler"));
}
