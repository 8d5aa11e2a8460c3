// The rows of the scene tree: sections, search, and made only when something changed.
#include <teapath/editor/scene_edits.h>
#include <teapath/editor/scene_tree.h>

#include <doctest/doctest.h>

#include <chrono>

using namespace tp;

namespace {

std::shared_ptr<const Scene> small_scene() {
    Scene scene;
    const MaterialId red = add_material(scene, MaterialKind::Lambertian),
                     lamp = add_material(scene, MaterialKind::DiffuseLight);
    for (int i = 0; i < 3; ++i) {
        Object o;
        o.id = {static_cast<uint32_t>(i + 1)};
        o.shape = SphereShape{};
        o.material = i == 1 ? lamp : red;
        if (i == 2) o.name = "Big BALL";
        scene.objects.edit().push_back(o);
    }
    scene.cameras.resize(1);
    scene.cameras[0].id = {1};
    add_sphere_grid(scene, {0, 0, 0});
    add_texture(scene, TextureKind::Checker);
    return std::make_shared<const Scene>(scene);
}

}  // namespace

TEST_CASE("tree: sections hold what belongs there") {
    const auto scene = small_scene();
    SceneTree tree;
    tree.update(scene, "");
    CHECK(tree.rows(TreeSection::Objects).size() == 3);  // two objects and the generator
    CHECK(tree.rows(TreeSection::Objects)[2].kind == ItemKind::Generator);
    CHECK(tree.rows(TreeSection::Lights) == std::vector{item_of(ObjectId{2})});
    CHECK(tree.positions(TreeSection::Lights) == std::vector<uint32_t>{1});
    CHECK(tree.rows(TreeSection::Cameras).size() == 1);
    CHECK(tree.rows(TreeSection::Materials).size() == 2);
    CHECK(tree.rows(TreeSection::Textures).size() == 1);
    CHECK(tree.rows(TreeSection::Background).size() == 1);
}

TEST_CASE("tree: search ignores case, finds unnamed things, and keeps the totals") {
    const auto scene = small_scene();
    SceneTree tree;
    tree.update(scene, "ball");
    CHECK(tree.rows(TreeSection::Objects) == std::vector{item_of(ObjectId{3})});
    CHECK(tree.total(TreeSection::Objects) == 3);
    tree.update(scene, "SPHERE 2");
    CHECK(tree.rows(TreeSection::Lights).size() == 1);
    CHECK(tree.rows(TreeSection::Objects).empty());
    tree.update(scene, "nothing of the kind");
    for (size_t s = 0; s < kTreeSections; ++s)
        CHECK(tree.rows(static_cast<TreeSection>(s)).empty());
}

TEST_CASE("tree: the rows are made once for a snapshot and a search") {
    const auto scene = small_scene();
    SceneTree tree;
    for (int frame = 0; frame < 10; ++frame)
        tree.update(scene, "");
    CHECK(tree.builds() == 1);
    tree.update(scene, "b");
    CHECK(tree.builds() == 2);
    tree.update(std::make_shared<const Scene>(*scene), "b");
    CHECK(tree.builds() == 3);
}

TEST_CASE("tree: a hundred thousand objects take a moment once, and nothing after") {
    Scene scene;
    scene.objects.edit().resize(100'000);
    for (size_t i = 0; i < scene.objects.size(); ++i)
        scene.objects.edit()[i].id = {static_cast<uint32_t>(i + 1)};
    const auto shared = std::make_shared<const Scene>(std::move(scene));
    SceneTree tree;
    tree.update(shared, "sphere 9");
    CHECK(tree.rows(TreeSection::Objects).size() == 11111);
    const auto start = std::chrono::steady_clock::now();
    for (int frame = 0; frame < 1000; ++frame)
        tree.update(shared, "sphere 9");
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    CHECK(tree.builds() == 1);
    CHECK(spent.count() < 0.05);
}
