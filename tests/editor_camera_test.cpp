// The camera and the history: flying is no step, a jump is one, and undo leads back to where a jump
// began.
#include <teapath/editor/document.h>
#include <teapath/editor/scene_edits.h>

#include <doctest/doctest.h>

using namespace tp;

namespace {

Camera flown(const Document& document, const Double3& by) {
    Camera camera = active_camera(document.scene());
    camera.look_from += by;
    camera.look_at += by;
    return camera;
}

void jump(Document& document, const Double3& place) {
    const CameraId id = active_camera(document.scene()).id;
    document.edit("Jump", "", [&](Scene& s) { find_camera(s, id)->look_from = place; });
}

void move_ball(Document& document) {
    document.edit("Move", "",
                  [](Scene& s) { s.objects.edit().back().transform.translation.x += 1; });
}

Double3 place(const Document& document) {
    return active_camera(document.scene()).look_from;
}

}  // namespace

TEST_CASE("flying copies nothing but the cameras") {
    Document document;
    const ScenePtr before = document.snapshot();
    document.fly(flown(document, {1, 0, 0}));
    CHECK(active_camera(*before).look_from != place(document));
    CHECK(&document.scene().objects.items() == &before->objects.items());
    CHECK(&document.scene().materials.items() == &before->materials.items());
    // An edit takes its own list along, and no other.
    move_ball(document);
    CHECK(&document.scene().objects.items() != &before->objects.items());
    CHECK(&document.scene().materials.items() == &before->materials.items());
}

TEST_CASE("flying is no step of the history and stays through undo and redo of other steps") {
    Document document;
    document.fly(flown(document, {1, 0, 0}));
    const Double3 there = place(document);
    CHECK(!document.can_undo());
    CHECK(document.is_modified());
    move_ball(document);
    document.fly(flown(document, {0, 2, 0}));
    document.undo();
    CHECK(place(document) == there + Double3(0, 2, 0));
    document.redo();
    CHECK(place(document) == there + Double3(0, 2, 0));
}

TEST_CASE("undo of a jump leads back to where the camera had been flown, redo to the jump's end") {
    Document document;
    document.fly(flown(document, {1, 0, 0}));
    const Double3 before = place(document), target(7, 7, 7);
    jump(document, target);
    document.fly(flown(document, {0, 0, 3}));
    document.undo();
    CHECK(place(document) == before);
    document.redo();
    CHECK(place(document) == target);
}

TEST_CASE("going over several steps at once passes the jumps among them in order") {
    Document document;
    const Double3 start = place(document);
    move_ball(document);
    jump(document, {5, 5, 5});
    move_ball(document);
    jump(document, {6, 6, 6});
    move_ball(document);
    document.go_to(0);
    CHECK(place(document) == start);
    document.go_to(3);
    CHECK(place(document) == Double3(5, 5, 5));
    document.go_to(5);
    CHECK(place(document) == Double3(6, 6, 6));
    document.go_to(4);
    CHECK(place(document) == Double3(6, 6, 6));
}

TEST_CASE("a drag of a camera value is one step, which undo takes back whole") {
    Document document;
    const double fov = active_camera(document.scene()).vertical_fov;
    for (int i = 1; i <= 5; ++i)
        document.edit("Field of view", "fov",
                      [&](Scene& s) { s.cameras[0].vertical_fov = fov + i; });
    CHECK(document.history().size() == 2);
    document.undo();
    CHECK(active_camera(document.scene()).vertical_fov == fov);
    document.redo();
    CHECK(active_camera(document.scene()).vertical_fov == fov + 5);
}
