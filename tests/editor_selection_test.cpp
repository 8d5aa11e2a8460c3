// One selection for objects and everything else, and the edits of what is selected.
#include <teapath/editor/document.h>
#include <teapath/editor/scene_edits.h>
#include <teapath/scene/validate.h>

#include <doctest/doctest.h>

using namespace tp;

namespace {

bool is_valid(const Scene& scene) {
    for (const Problem& p : validate(scene))
        if (p.fatal) return false;
    return true;
}

}  // namespace

TEST_CASE("selection: things of one kind at a time, the last one is the active one") {
    Document document;
    const ObjectId first = document.scene().objects[0].id, second = document.scene().objects[1].id;
    const MaterialId material = document.scene().materials[0].id;
    document.select(item_of(first));
    document.select(item_of(second), true);
    CHECK(document.selected_items() == std::vector{item_of(first), item_of(second)});
    CHECK(document.selection.size() == 2);
    document.select(item_of(first), true);  // again takes it away
    CHECK(document.selected_items() == std::vector{item_of(second)});

    document.select(item_of(material), true);  // another kind takes the place
    CHECK(document.selection.empty());
    CHECK(document.is_selected(item_of(material)));
    CHECK(!document.is_selected(item_of(second)));
    document.select(background_item());
    CHECK(document.selected_items() == std::vector{background_item()});

    // What the viewport selects counts before the rest.
    document.select(first);
    CHECK(document.selected_items() == std::vector{item_of(first)});
    CHECK(!document.is_selected(background_item()));
    document.select(ObjectId{});
    CHECK(document.selection.empty());
}

TEST_CASE("selection: what an edit or an undo removes is selected no longer") {
    Document document;
    MaterialId made;
    document.edit("Add", "", [&](Scene& s) { made = add_material(s, MaterialKind::Metal); });
    document.select(item_of(made));
    document.undo();
    CHECK(document.selected_items().empty());
    std::vector<SceneItem> all;
    for (const Object& o : document.scene().objects)
        all.push_back(item_of(o.id));
    document.select_items(all);
    document.edit("Delete", "", [&](Scene& s) { delete_items(s, {all[0]}); });
    CHECK(document.selected_items() == std::vector{all[1]});
}

TEST_CASE("items: delete removes every use, and leaves the last camera and the background") {
    Document document;
    Scene scene = document.scene();
    const TextureId texture = add_texture(scene, TextureKind::Checker);
    scene.materials.edit()[0].color.texture = texture;
    delete_items(scene, {item_of(texture), item_of(scene.materials[1].id), background_item(),
                         item_of(scene.cameras[0].id)});
    CHECK(scene.textures.empty());
    CHECK(!scene.materials[0].color.texture);
    CHECK(scene.materials.size() == 1);
    CHECK(scene.cameras.size() == 1);
    CHECK(is_valid(scene));
    CHECK(!why_not_deleted(scene, item_of(scene.cameras[0].id)).empty());

    const CameraId second = add_camera(scene, scene.cameras[0]);
    scene.active_camera = second;
    delete_items(scene, {item_of(second)});
    CHECK(scene.cameras.size() == 1);
    CHECK(is_valid(scene));
}

TEST_CASE("items: copies and new names are valid, whatever is asked for") {
    Document document;
    Scene scene = document.scene();
    const GeneratorId grid = add_sphere_grid(scene, {0, 0, 0});
    const TextureId texture = add_texture(scene, TextureKind::Image);
    std::vector<SceneItem> all = {item_of(grid),
                                  item_of(texture),
                                  item_of(scene.cameras[0].id),
                                  item_of(scene.materials[0].id),
                                  item_of(scene.objects[0].id),
                                  background_item()};
    const std::vector<SceneItem> made = duplicate_items(scene, all);
    CHECK(made.size() == 5);
    for (const SceneItem item : made) {
        CHECK(exists(scene, item));
        CHECK(!item_name(scene, item).empty());
    }
    CHECK(is_valid(scene));
    rename_item(scene, item_of(scene.materials[1].id), scene.materials[0].name);
    CHECK(scene.materials[1].name != scene.materials[0].name);
    rename_item(scene, item_of(scene.objects[0].id), "ball");
    CHECK(scene.objects[0].name == "ball");
    rename_item(scene, item_of(scene.materials[0].id), scene.materials[0].name);  // itself
    CHECK(scene.materials[0].name == "ground");
    CHECK(is_valid(scene));
    CHECK(item_name(scene, {ItemKind::Material, 12345}).empty());
}

TEST_CASE("items: materials of many objects at once") {
    Document document;
    Scene scene = document.scene();
    const MaterialId glass = add_material(scene, MaterialKind::Dielectric);
    assign_material(scene, {scene.objects[0].id, scene.objects[1].id}, glass);
    CHECK(scene.objects[0].material == glass);
    CHECK(scene.objects[1].material == glass);
    set_visible(scene, {scene.objects[1].id}, false);
    CHECK(scene.objects[0].visible);
    CHECK(!scene.objects[1].visible);
}
