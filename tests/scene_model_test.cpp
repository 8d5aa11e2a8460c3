// Models in a scene: matrices taken apart, things under fresh ids and names, and what was changed
// of them kept in the scene file by the names of the model's parts.
#include "../src/io/scene_json.h"
#include "support/meshes.h"

#include <teapath/io/scene_file.h>
#include <teapath/scene/scene.h>

#include <doctest/doctest.h>

#include <random>

using namespace tp;

namespace {

double difference(const DoubleMat4& a, const DoubleMat4& b) {
    double largest = 0;
    for (int i = 0; i < 4; ++i)
        largest = std::max(largest, glm::length(a[i] - b[i]));
    return largest;
}

DoubleMat4 whole(const SplitTransform& split) {
    return world_from_object(split.transform) * DoubleMat4(split.placement);
}

DoubleMat4 world_of(const Object& object) {
    return world_from_object(object.transform) *
           DoubleMat4(std::get<MeshShape>(object.shape).placement);
}

// Two wheels and a body; the body's colour is an image.
std::shared_ptr<const ModelContent> car() {
    auto content = std::make_shared<ModelContent>();
    Texture image;
    image.id = {1};
    image.name = "stripes";
    image.kind = TextureKind::Image;
    image.file = {"car.glb#image/0", std::make_shared<const Image>(Image{
                                         1, 1, 3, PixelFormat::U8, std::vector<std::byte>(3)})};
    image.part = {{}, "stripes"};
    content->textures = {image};
    Material paint, rubber;
    paint.id = {1};
    paint.name = "paint";
    paint.kind = MaterialKind::Principled;
    paint.color.texture = {1};
    paint.surface.normal = {1};
    paint.surface.coat.value = 1;
    paint.part = {{}, "paint"};
    rubber.id = {2};
    rubber.name = "rubber";
    rubber.part = {{}, "rubber"};
    content->materials = {paint, rubber};
    const auto mesh = share(test::box_mesh());
    for (const auto& [path, material] :
         {std::pair{"body", 1}, std::pair{"body/wheel", 2}, std::pair{"body/wheel 2", 2}}) {
        Object object;
        object.id = {static_cast<uint32_t>(content->objects.size()) + 1};
        object.name = path;
        object.shape = MeshShape{{std::string("car.glb#") + path, mesh}, true, DoubleMat3(1)};
        object.transform.translation = {static_cast<double>(object.id.value), 0, 0};
        object.material = {static_cast<uint32_t>(material)};
        object.part = {{}, path};
        content->objects.push_back(object);
    }
    return content;
}

Model model_of_car() {
    Model model;
    model.name = "car";
    model.path = "models/car.glb";
    model.content = car();
    return model;
}

const Object& part(const Scene& scene, const std::string& path) {
    for (const Object& object : scene.objects)
        if (object.part.path == path) return object;
    FAIL("no part " << path);
    return scene.objects.front();
}

// Writes the scene and reads it back, with the contents of its models at hand.
Scene read_back(const Scene& scene) {
    const Json json = json_of_scene(scene, false);
    ModelCache models("", "test", &scene);
    Scene again = scene_of_json(json, "test.json", models);
    load_images(again, "test", models);
    load_meshes(again, "test", models);
    CHECK(pretty_json(json_of_scene(again, false)) == pretty_json(json));
    return again;
}

}  // namespace

TEST_CASE("model: any matrix is a transform after a shear") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-3, 3);
    for (int i = 0; i < 200; ++i) {
        DoubleMat4 m(1);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row)
                m[column][row] = number(random);
        const auto split = split_transform(m);
        REQUIRE(split);
        CHECK(difference(whole(*split), m) < 1e-9);
    }
    // What has no shear gets none, mirrored or not.
    for (const double mirror : {1.0, -1.0}) {
        const Transform t{{1, 2, 3}, {10, 20, 30}, {2, 3, 4 * mirror}};
        const SplitTransform split = split_transform(world_from_object(t)).value();
        CHECK(split.placement == DoubleMat3(1));
        CHECK(difference(whole(split), world_from_object(t)) < 1e-12);
    }
    CHECK_FALSE(split_transform(DoubleMat4(DoubleMat3(0))));
}

TEST_CASE("model: its things stand in the scene under ids and names of their own") {
    Scene scene;
    Material paint;
    paint.id = {7};
    paint.name = "paint";
    scene.materials = {paint};
    const ModelId id = add_model(scene, model_of_car());
    REQUIRE(scene.objects.size() == 3);
    CHECK(scene.materials.size() == 3);
    CHECK(scene.materials[1].name == "paint 2");
    CHECK(find(scene, part(scene, "body").material)->name == "paint 2");
    CHECK(part(scene, "body").material == part(scene, "body").material);
    CHECK(find(scene, scene.materials[1].color.texture)->name == "stripes");
    CHECK(scene.textures[0].file.path == "models/car.glb#image/0");
    const ModelId second = add_model(scene, model_of_car());
    CHECK(second != id);
    CHECK(scene.objects.size() == 6);
    CHECK(scene.objects[3].material != scene.objects[0].material);
    CHECK(scene.objects[5].material == scene.objects[4].material);
}

TEST_CASE("model: its transform comes after those of its objects") {
    Scene scene;
    Model model = model_of_car();
    model.transform = {{0, 5, 0}, {0, 90, 0}, {1, 2, 3}};
    const auto content = model.content;
    const DoubleMat4 under = world_from_object(model.transform);
    add_model(scene, std::move(model));
    for (size_t i = 0; i < 3; ++i)
        CHECK(difference(world_of(scene.objects[i]), under * world_of(content->objects[i])) < 1e-9);
}

TEST_CASE("model: a scene file keeps the path and what was changed") {
    Scene scene = scene_of_model(model_of_car());
    CHECK(read_back(scene) == scene);
    CHECK(scene_text(scene).find("\"body") == std::string::npos);

    // Changes of every kind: values, references, kinds, names, what is taken away.
    Material chrome;
    chrome.id = {90};
    chrome.name = "chrome";
    chrome.kind = MaterialKind::Metal;
    scene.materials.edit().push_back(chrome);
    for (Object& object : scene.objects.edit()) {
        if (object.part.path == "body") object.transform.rotation.y = 45;
        if (object.part.path == "body/wheel") {
            object.material = chrome.id;
            object.visible = false;
            object.name = "front wheel";
        }
    }
    std::erase_if(scene.objects.edit(),
                  [](const Object& o) { return o.part.path == "body/wheel 2"; });
    for (Material& material : scene.materials.edit()) {
        if (material.part.path == "paint") {
            material.name = "chrome";  // clashes
            material.surface.normal = {};
            material.surface.coat.value = 0.25;
            material.color = {{1, 0, 0}, {}};
        }
        if (material.part.path == "rubber") {
            material.kind = MaterialKind::DiffuseLight;
            material.strength = 3;
        }
    }
    scene.textures.edit()[0].repeat = {2, 2};
    const Scene again = read_back(scene);
    REQUIRE(again.objects.size() == scene.objects.size());
    CHECK(part(again, "body").transform.rotation.y == 45);
    CHECK(std::get<MeshShape>(part(again, "body").shape).file.mesh != nullptr);
    const Object& wheel = part(again, "body/wheel");
    CHECK((!wheel.visible && wheel.name == "front wheel"));
    CHECK(find(again, wheel.material)->kind == MaterialKind::Metal);
    const Material& paint = *find(again, part(again, "body").material);
    CHECK((paint.kind == MaterialKind::Principled && paint.surface.coat.value == 0.25));
    CHECK((!paint.surface.normal && !paint.color.texture && paint.color.color.x == 1));
    for (const Material& material : again.materials)
        if (material.part.path == "rubber") {
            CHECK(material.kind == MaterialKind::DiffuseLight);
            CHECK(material.strength == 3);
        }
    CHECK(again.textures[0].repeat == Double2(2, 2));
    CHECK(again.textures[0].file.image != nullptr);
}

TEST_CASE("model: a duplicate of one of its objects finds its mesh") {
    Scene scene = scene_of_model(model_of_car());
    Object copy = part(scene, "body/wheel");
    copy.id = {77};
    copy.part = {};
    scene.objects.edit().push_back(copy);
    const Scene again = read_back(scene);
    CHECK(std::get<MeshShape>(again.objects.back().shape).file.mesh ==
          std::get<MeshShape>(copy.shape).file.mesh);
}

TEST_CASE("model: a missing file loses nothing of the scene file") {
    Scene scene = scene_of_model(model_of_car());
    for (Object& object : scene.objects.edit())
        if (object.part.path == "body") object.visible = false;
    Object own;
    own.id = {50};
    own.material = part(scene, "body").material;
    scene.objects.edit().push_back(own);
    const std::string text = scene_text(scene);
    const Scene without = parse_scene(text, "/nowhere", "test.json");
    CHECK(without.objects.size() == 2);  // the lamp, and the one with the model's material
    // With the file again, the changes are there.
    ModelCache models("", "test", &scene);
    const Scene again = scene_of_json(json_of_scene(without, false), "test.json", models);
    CHECK_FALSE(part(again, "body").visible);
}

TEST_CASE("model: the camera has all of it in the picture") {
    const Scene scene = scene_of_model(model_of_car());
    REQUIRE(scene.cameras.size() == 1);
    const Camera& camera = scene.cameras[0];
    const Double3 forward = glm::normalize(camera.look_at - camera.look_from);
    const Double3 right = glm::normalize(glm::cross(forward, Double3(0, 1, 0)));
    const Double3 up = glm::cross(right, forward);
    const double tan_y = std::tan(camera.vertical_fov / 2 * 3.14159265358979 / 180);
    double widest = 0;
    for (const Object& object : scene.objects) {
        const auto* mesh = std::get_if<MeshShape>(&object.shape);
        if (!mesh) continue;
        for (const Float3& position : mesh->file.mesh->positions) {
            const Double3 p =
                Double3(world_of(object) * Double4(Double3(position), 1)) - camera.look_from;
            const double depth = glm::dot(p, forward);
            REQUIRE(depth > 0);
            widest = std::max({widest, std::abs(glm::dot(p, up)) / (depth * tan_y),
                               std::abs(glm::dot(p, right)) / (depth * tan_y * 16 / 9)});
        }
    }
    CHECK(widest < 1);
    CHECK(widest > 0.5);
}
