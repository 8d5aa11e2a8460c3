// The panels by mouse and keyboard: rows, tree, inspector of several things, presets.
#include "panels/add_menu.h"
#include "place_in_view.h"
#include "window_test.h"

#include <teapath/editor/scene_edits.h>
#include <teapath/scene/validate.h>

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace tp;
using namespace tp::test;

namespace {

const char* const kRow = "###row";

// The row of a thing in the scene tree.
ImGuiID row_of(ImGuiTestContext* ctx, SceneItem item) {
    const ImGuiWindow* tree = ctx->WindowInfo("//Scene/tree").Window;
    REQUIRE(tree != nullptr);
    ImGuiID id = tree->ID;
    const int kind = static_cast<int>(item.kind), number = static_cast<int>(item.id);
    id = ImHashData(&kind, sizeof kind, id);
    id = ImHashData(&number, sizeof number, id);
    return ImHashStr(kRow, 0, id);
}

void click_row(ImGuiTestContext* ctx, SceneItem item) {
    ctx->ItemClick(row_of(ctx, item));
}

// The field of a row of the inspector.
ImGuiTestRef field(ImGuiTestContext* ctx, const char* name) {
    const std::string ref = std::string("//Inspector/**/##") + name;
    return ctx->ItemInfo(ref.c_str()).ID;
}

const Object& object(const WindowTest& t, uint32_t id) {
    return *find(t.scene(), ObjectId{id});
}

double radius(const WindowTest& t, uint32_t id) {
    return std::get<SphereShape>(object(t, id).shape).radius;
}

}  // namespace

TEST_CASE("panels: a row takes expressions, drags, and goes back by a double click on its label") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        t.app->document.select(ObjectId{2});
        ctx->Yield(2);
        ctx->ItemInputValue(field(ctx, "Radius"), "2*pi/3");
        CHECK(radius(t, 2) == doctest::Approx(2 * std::acos(-1.0) / 3));
        CHECK(t.app->document.history().size() == 2);
        ctx->ItemInputValue(field(ctx, "Radius"), "x/2");
        CHECK(radius(t, 2) == doctest::Approx(std::acos(-1.0) / 3));
        ctx->ItemInputValue(field(ctx, "Radius"), "nonsense");
        CHECK(radius(t, 2) == doctest::Approx(std::acos(-1.0) / 3));

        // A whole drag is one step.
        const size_t steps = t.app->document.history().size();
        ctx->ItemDragWithDelta(field(ctx, "Radius"), {60, 0});
        CHECK(radius(t, 2) > 1.05);
        CHECK(t.app->document.history().size() == steps + 1);
        ctx->ItemDragWithDelta(field(ctx, "Radius"), {-20, 0});
        CHECK(t.app->document.history().size() == steps + 2);

        ctx->ItemDoubleClick("//Inspector/**/Radius");
        CHECK(radius(t, 2) == 0.5);
    });
}

TEST_CASE("panels: a row's menu copies, pastes and resets") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        t.app->document.select(ObjectId{2});
        ctx->Yield(2);
        ctx->ItemInputValue(field(ctx, "Radius"), "0.7");
        ctx->ItemClick("//Inspector/**/Radius", ImGuiMouseButton_Right);
        ctx->ItemClick("//$FOCUSED/Copy");
        CHECK(std::string(ImGui::GetClipboardText()) == "0.7");
        ImGui::SetClipboardText("1/4");
        ctx->ItemClick("//Inspector/**/Radius", ImGuiMouseButton_Right);
        ctx->ItemClick("//$FOCUSED/Paste");
        CHECK(radius(t, 2) == 0.25);
        ctx->ItemClick("//Inspector/**/Radius", ImGuiMouseButton_Right);
        ctx->ItemClick("//$FOCUSED/Reset to default");
        CHECK(radius(t, 2) == 0.5);
    });
}

TEST_CASE("panels: an edit goes to all selected objects, of vectors only what was edited") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        t.app->document.select_items(
            {item_of(ObjectId{2}), item_of(ObjectId{3}), item_of(ObjectId{4})});
        ctx->Yield(2);
        ctx->ItemInputValue(field(ctx, "Radius"), "0.3");
        for (const uint32_t id : {2u, 3u, 4u})
            CHECK(radius(t, id) == 0.3);
        ctx->ItemInputValue(field(ctx, "Centrey"), "2");
        for (const uint32_t id : {2u, 3u, 4u}) {
            const Double3 center = std::get<SphereShape>(object(t, id).shape).center;
            CHECK(center.y == 2);
            CHECK(center.x == doctest::Approx(1.2 * (static_cast<double>(id) - 3)));
        }
        CHECK(t.app->document.history().size() == 3);
    });
}

TEST_CASE("panels: what a scene may not hold is refused, and the scene stays") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        t.app->document.select(ObjectId{2});
        ctx->Yield(2);
        const Scene before = t.scene();
        ctx->ItemInputValue(field(ctx, "Scalex"), "0");
        CHECK(t.scene() == before);
        CHECK_FALSE(t.app->ui.toasts.empty());
    });
}

TEST_CASE("panels: clicks in the tree select, Ctrl adds, Shift takes a range") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        const Document& document = t.app->document;
        click_row(ctx, item_of(ObjectId{1}));
        CHECK(document.selected_items() == std::vector{item_of(ObjectId{1})});
        ctx->KeyDown(ImGuiMod_Shift);
        click_row(ctx, item_of(ObjectId{3}));
        ctx->KeyUp(ImGuiMod_Shift);
        CHECK(document.selection.size() == 3);
        ctx->KeyDown(ImGuiMod_Ctrl);
        click_row(ctx, item_of(ObjectId{2}));
        ctx->KeyUp(ImGuiMod_Ctrl);
        CHECK(document.selection.size() == 2);
        CHECK_FALSE(document.is_selected(ObjectId{2}));
    });
}

TEST_CASE("panels: a name is typed in place after F2 and after a double click") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        click_row(ctx, item_of(ObjectId{3}));
        ctx->KeyPress(ImGuiKey_F2);
        ctx->Yield(3);
        ctx->KeyCharsReplaceEnter("a name with % and \xc3\xa4");
        CHECK(object(t, 3).name == "a name with % and \xc3\xa4");
        ctx->ItemDoubleClick(row_of(ctx, item_of(ObjectId{2})));
        ctx->Yield(3);
        ctx->KeyCharsReplace("not this");
        ctx->KeyPress(ImGuiKey_Escape);
        ctx->Yield(2);
        CHECK(object(t, 2).name == "matt ball");
        CHECK_FALSE(t.app->ui.tree.is_renaming);
    });
}

TEST_CASE("panels: a camera's menu makes it the default of the file, and gives it the view") {
    Scene scene = small_scene();
    Camera other = scene.cameras.front();
    other.id = {2};
    other.name = "other";
    other.look_from = {3, 2, 1};
    other.vertical_fov = 20;
    scene.cameras.push_back(other);
    WindowTest t(scene, 1280, 1600);
    t.run([&](ImGuiTestContext* ctx) {
        const auto choose = [&](CameraId camera, const char* item) {
            ctx->ItemClick(row_of(ctx, item_of(camera)), ImGuiMouseButton_Right);
            ctx->ItemClick((std::string("//$FOCUSED/") + item).c_str());
            ctx->Yield(2);
        };
        choose({2}, "Give it this view");
        const Camera placed = *find(t.scene(), CameraId{2});
        CHECK(placed.look_from == t.camera().look_from);
        CHECK(placed.vertical_fov == 20);
        CHECK(t.camera().id == CameraId{1});
        choose({2}, "Set as default");
        CHECK(t.scene().active_camera == CameraId{2});
        t.app->document.undo();
        t.app->document.undo();
        CHECK(find(t.scene(), CameraId{2})->look_from == Double3(3, 2, 1));
        CHECK(t.camera().id == CameraId{1});
    });
}

TEST_CASE("panels: a material is dragged onto an object in the tree") {
    WindowTest t(small_scene(), 1280, 1600);  // all rows are in sight
    t.run([&](ImGuiTestContext* ctx) {
        ctx->ItemDragAndDrop(row_of(ctx, item_of(MaterialId{4})),
                             row_of(ctx, item_of(ObjectId{2})));
        CHECK(object(t, 2).material == MaterialId{4});
    });
}

TEST_CASE("panels: everything of the Add menu is added, selected and valid, on what is in view") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        for (const char* item :
             {"Sphere", "Rectangle XY", "Rectangle XZ", "Rectangle YZ", "Rectangle", "Box", "Disk",
              "Triangle", "Sphere grid", "Sphere light", "Camera"}) {
            const size_t before = t.app->document.history().size();
            ctx->MenuClick((std::string("//##MainMenuBar/Add/###") + item).c_str());
            ctx->Yield();
            INFO(item);
            CHECK(t.app->document.history().size() == before + 1);
            CHECK(t.app->document.selected_items().size() == 1);
        }
        for (const Problem& problem : validate(t.scene()))
            CHECK_FALSE_MESSAGE(problem.fatal, problem.what);
    });
    const Place place = place_in_view(small_scene());
    CHECK(place.is_surface);  // the ball in the middle
    CHECK(place.point.z == doctest::Approx(0.5).epsilon(0.2));
    Scene sky = small_scene();
    sky.objects.edit().clear();
    CHECK_FALSE(place_in_view(sky).is_surface);
}

TEST_CASE("panels: a mesh of the program's own is added, and made anew by its recipe") {
    WindowTest t;
    const auto triangles = [&] {
        const Object* object = find(t.scene(), t.app->document.selection.back());
        const auto& mesh = std::get<MeshShape>(object->shape).file.mesh;
        return mesh ? mesh->triangles.size() : 0;
    };
    const auto is_idle = [&] { return t.app->ui.jobs.is_idle(); };
    t.run([&](ImGuiTestContext* ctx) { ctx->MenuClick("//##MainMenuBar/Add/###Made mesh/Torus"); });
    REQUIRE(t.frames_until(is_idle));
    t.frames(3);
    REQUIRE(t.app->document.selection.size() == 1);
    const Object added = *find(t.scene(), t.app->document.selection.back());
    CHECK(added.name == "Torus");
    CHECK(std::get<MeshShape>(added.shape).file.path == "procedural://torus?tube=0.25&detail=96");
    const size_t fine = triangles();
    CHECK(fine > 1000);

    const auto type = [&](const char* recipe) {
        t.run([&](ImGuiTestContext* ctx) {
            ctx->ItemInput("**/##recipe");
            ctx->KeyCharsReplaceEnter(recipe);
        });
        REQUIRE(t.frames_until(is_idle));
        t.frames(3);
    };
    type("torus?tube=0.3&detail=24");
    CHECK(triangles() < fine / 4);
    const size_t steps = t.app->document.history().size();
    type("procedural://torus?tube=hello");  // refused, with a message
    CHECK(t.app->document.history().size() == steps);
    CHECK(triangles() < fine / 4);
    t.app->document.undo();
    CHECK(triangles() == fine);
}

TEST_CASE("panels: every kind of thing has an inspector that can be drawn") {
    Scene scene = small_scene();
    add_sphere_grid(scene, {0, 0, 0});
    add_texture(scene, TextureKind::Checker);
    add_texture(scene, TextureKind::Image);
    add_texture(scene, TextureKind::Constant);
    WindowTest t(scene);
    t.run([&](ImGuiTestContext* ctx) {
        std::vector<SceneItem> items = {background_item(), item_of(t.scene().cameras[0].id),
                                        item_of(t.scene().generators[0].id)};
        for (const Texture& texture : t.scene().textures)
            items.push_back(item_of(texture.id));
        for (const Material& material : t.scene().materials)
            items.push_back(item_of(material.id));
        const Scene before = t.scene();
        for (const SceneItem item : items) {
            t.app->document.select(item);
            ctx->Yield(3);
            ImGuiTestItemList found;
            ctx->GatherItems(&found, "//Inspector", -1);
            CHECK(found.GetSize() > 3);
        }
        CHECK(t.scene() == before);  // looking changes nothing
    });
}

TEST_CASE("panels: pictures of materials are rendered in the background") {
    WindowTest t;
    t.run([&](ImGuiTestContext* ctx) {
        t.app->document.select(item_of(MaterialId{3}));
        CHECK(t.yield_until(
            ctx, [&] { return t.app->previews.rendered() > 0; }, 60));
    });
}

TEST_CASE("panels: a hundred thousand objects and a name of 200 characters") {
    Scene scene = small_scene();
    scene.objects.edit()[1].name = std::string(200, 'w');
    WindowTest t(scene);
    t.app->document.edit("Many", "", [](Scene& s) {
        for (uint32_t i = 5; i < 100'000; ++i) {
            Object o = s.objects[1];
            o.id = {i};
            o.shape = SphereShape{{0.01 * i, 0.5, -20}, 0.004};
            s.objects.edit().push_back(o);
        }
    });
    t.frames(3);
    const int builds = t.app->ui.tree.rows.builds();
    float interface_ms = 0;
    for (int frame = 0; frame < 20; ++frame) {
        t.frames();
        const MetricsState& m = t.app->ui.metrics;
        interface_ms += m.interface_ms[(m.frames - 1) % MetricsState::kFrames] / 20;
    }
    CHECK(t.app->ui.tree.rows.builds() == builds);  // nothing is made anew for a still scene
    MESSAGE("interface " << interface_ms << " ms a frame");
    CHECK(interface_ms < 30);  // of a debug or sanitizer build too
}
