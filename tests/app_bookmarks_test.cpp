// Bookmarks of views, and drags of the gizmo.
#include "app/viewport/bookmarks.h"
#include "app/viewport/gizmo_drag.h"

#include <teapath/editor/document.h>
#include <teapath/io/scene_file.h>

#include <doctest/doctest.h>
#include <glm/gtc/matrix_transform.hpp>

#include <filesystem>

using namespace tp;

namespace {

Camera view_of(double x) {
    Camera camera;
    camera.look_from = {x, 1, 4};
    camera.vertical_fov = 20 + x;
    camera.focus_distance = x;
    return camera;
}

void look(Document& document, const Camera& view) {
    Camera camera = view;
    const Camera active = active_camera(document.scene());
    camera.id = active.id;
    camera.name = active.name;
    document.fly(camera);
}

Object ball(uint32_t id, const Double3& place) {
    Object object;
    object.id = {id};
    object.shape = SphereShape{};
    object.transform.translation = place;
    return object;
}

}  // namespace

TEST_CASE("a bookmark keeps the whole view, is undone, and is in the scene file") {
    Document document;
    const CameraId active = active_camera(document.scene()).id;
    look(document, view_of(3));
    CHECK(!find_bookmark(document.scene(), 2));
    document.edit("Set", "", [](Scene& s) { set_bookmark(s, 2); });
    look(document, view_of(9));
    document.edit("Go", "", [](Scene& s) { go_to_bookmark(s, 2); });
    CHECK(active_camera(document.scene()).look_from == Double3(3, 1, 4));
    CHECK(active_camera(document.scene()).vertical_fov == 23);
    CHECK(active_camera(document.scene()).id == active);

    // A jump is undone to where it began; the bookmark itself is a step too.
    document.undo();
    CHECK(active_camera(document.scene()).look_from == Double3(9, 1, 4));
    const auto file = std::filesystem::temp_directory_path() / "teapath_bookmarks_test.json";
    save_scene(document.scene(), file);
    const Scene loaded = load_scene(file);
    std::filesystem::remove(file);
    REQUIRE(find_bookmark(loaded, 2));
    CHECK(find_bookmark(loaded, 2)->look_from == Double3(3, 1, 4));
    CHECK(active_camera(loaded).look_from == Double3(9, 1, 4));
    document.undo();
    CHECK(!find_bookmark(document.scene(), 2));
}

TEST_CASE("a bookmark that is set again is replaced; one that is not set leads nowhere") {
    Document document;
    Scene scene = document.scene();
    set_bookmark(scene, 1);
    set_bookmark(scene, 9);
    const size_t count = scene.cameras.size();
    scene.cameras.front().look_from = {5, 5, 5};
    set_bookmark(scene, 1);
    CHECK(scene.cameras.size() == count);
    CHECK(find_bookmark(scene, 1)->look_from == Double3(5, 5, 5));
    CHECK(find_bookmark(scene, 1)->id != find_bookmark(scene, 9)->id);
    const Scene before = scene;
    go_to_bookmark(scene, 4);
    CHECK(scene == before);
    Scene empty;
    set_bookmark(empty, 1);
    CHECK(active_camera(empty).name.empty());
}

TEST_CASE("a drag places every object from where it began, about the middle of them") {
    const Object a = ball(1, {1, 0, 0}), b = ball(2, {3, 0, 0});
    GizmoDrag drag;
    drag.begin({&a, &b}, {2, 0, 0}, DoubleMat3(1));
    drag.now[3] = Double4(2, 5, 0, 1);
    CHECK(drag.placed(GizmoKind::Move)[0].transform.translation == Double3(1, 5, 0));
    drag.now[3] = Double4(2, 0.5, 0, 1);  // a later frame takes the place of an earlier one
    std::vector<GizmoDrag::Start> placed = drag.placed(GizmoKind::Move);
    CHECK(placed[0].transform.translation == Double3(1, 0.5, 0));
    CHECK(placed[1].transform.translation == Double3(3, 0.5, 0));

    drag.now = drag.start * glm::rotate(DoubleMat4(1), 3.14159265358979323846, Double3(0, 1, 0));
    placed = drag.placed(GizmoKind::Rotate);
    CHECK(glm::distance(placed[0].transform.translation, Double3(3, 0, 0)) < 1e-9);
    CHECK(glm::distance(placed[1].transform.translation, Double3(1, 0, 0)) < 1e-9);

    drag.now = drag.start * glm::scale(DoubleMat4(1), Double3(2, 1, 1));
    placed = drag.placed(GizmoKind::Scale);
    CHECK(placed[0].transform.translation == Double3(0, 0, 0));
    CHECK(placed[0].transform.scale == Double3(2, 1, 1));
}

TEST_CASE("scaled by the middle a sphere keeps three equal scales, whatever rounding does") {
    const Object a = ball(1, {0, 0, 0});
    GizmoDrag drag;
    drag.begin({&a}, {0, 0, 0}, DoubleMat3(1));
    drag.is_uniform = true;
    drag.now =
        DoubleMat4(glm::mat4(glm::scale(DoubleMat4(1), Double3(1.3, 1.3 + 1e-7, 1.3 - 1e-7))));
    const Double3 scale = drag.placed(GizmoKind::Scale)[0].transform.scale;
    CHECK(scale.x == scale.y);
    CHECK(scale.y == scale.z);
    CHECK(scale.x == doctest::Approx(1.3));
}

TEST_CASE("the gizmo's axes are the world's or the object's") {
    Object a = ball(1, {0, 0, 0});
    a.transform.rotation = {0, 90, 0};
    a.transform.scale = {3, 1, 1};
    CHECK(gizmo_axes(a, false) == DoubleMat3(1));
    CHECK(glm::distance(gizmo_axes(a, true)[0], Double3(0, 0, -1)) < 1e-9);
}
