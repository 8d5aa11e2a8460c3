// Placement of objects, cameras, look-ups: what the document derives from its own values.
#include <teapath/scene/scene.h>

#include <doctest/doctest.h>

using namespace tp;

namespace {

Double3 apply(const Transform& t, const Double3& p) {
    return Double3(world_from_object(t) * Double4(p, 1));
}

bool near(const Double3& a, const Double3& b) {
    return glm::distance(a, b) < 1e-12;
}

}  // namespace

TEST_CASE("transform: scale, then rotation about x, y, z, then translation") {
    Transform t;
    CHECK(world_from_object(t) == DoubleMat4(1));
    t.scale = {2, 3, 4};
    CHECK(apply(t, {1, 1, 1}) == Double3(2, 3, 4));
    t.translation = {10, 20, 30};
    CHECK(apply(t, {1, 1, 1}) == Double3(12, 23, 34));
    t.rotation = {0, 0, 90};  // x to y, after scaling
    CHECK(apply(t, {1, 0, 0}) == Double3(10, 22, 30));

    // About the axes of the world, one after the other.
    t = {};
    t.rotation = {90, 90, 0};
    CHECK(apply(t, {0, 1, 0}) == Double3(1, 0, 0));  // y to z about x, z to x about y
    t.rotation = {0, 90, 90};
    CHECK(apply(t, {0, 0, 1}) == Double3(0, 1, 0));  // z to x about y, x to y about z
    t.rotation = {30, 40, 50};
    CHECK(near(apply(t, {0, 0, 0}), {0, 0, 0}));
    CHECK(glm::determinant(linear_part(t)) == doctest::Approx(1));
}

TEST_CASE("transform: quarter turns are exact, whole turns do nothing") {
    Transform t;
    for (const double turn : {90.0, 180.0, 270.0, -90.0, 450.0, 3690.0}) {
        t.rotation = {turn, 0, 0};
        const DoubleMat3 m = linear_part(t);
        for (int i = 0; i < 9; ++i) {
            const double entry = m[i / 3][i % 3];
            CHECK((entry == 0 || entry == 1 || entry == -1));
        }
    }
    t.rotation = {360, -720, 3600};
    CHECK(linear_part(t) == DoubleMat3(1));
}

TEST_CASE("scene: things are found by id, and none by no id") {
    Scene scene;
    scene.objects.edit().resize(3);
    for (uint32_t i = 0; i < 3; ++i)
        scene.objects.edit()[i].id = {10 - i};
    CHECK(find(scene, ObjectId{9}) == &scene.objects[1]);
    CHECK(find(scene, ObjectId{1}) == nullptr);
    CHECK(find(scene, ObjectId{}) == nullptr);
    scene.objects.edit()[0].id = {};
    CHECK(find(scene, ObjectId{}) == nullptr);
}

TEST_CASE("scene: the active camera, the first one, or a default") {
    Scene scene;
    CHECK(active_camera(scene) == Camera{});
    scene.cameras.resize(2);
    scene.cameras[0].id = {1};
    scene.cameras[1].id = {2};
    CHECK(active_camera(scene).id == CameraId{1});
    scene.active_camera = {2};
    CHECK(active_camera(scene).id == CameraId{2});
    scene.active_camera = {3};
    CHECK(active_camera(scene).id == CameraId{1});
}

TEST_CASE("scene: focus is at look_at unless the camera says otherwise") {
    Camera camera;
    camera.look_from = {0, 0, 5};
    CHECK(effective_focus_distance(camera) == 5);
    camera.focus_distance = 2;
    CHECK(effective_focus_distance(camera) == 2);
}
