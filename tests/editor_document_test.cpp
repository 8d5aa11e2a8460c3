// A document and its file: the saved mark, and errors that leave the document as it was.
#include "support/temporary_folder.h"

#include <teapath/core/error.h>
#include <teapath/editor/document.h>

#include <doctest/doctest.h>

#include <fstream>
#include <string>

using namespace tp;
using tp::test::TemporaryFolder;

TEST_CASE("document: the saved mark follows undo and redo past the saved step, and flights") {
    TemporaryFolder folder;
    Document document;
    const auto rename = [&](const std::string& name) {
        document.edit("Name", "", [&](Scene& s) { s.name = name; });
    };
    rename("a");
    rename("b");
    document.save(folder.path / "scene.json");
    CHECK(!document.is_modified());
    CHECK(document.title() == "scene.json");
    document.undo();
    CHECK(document.is_modified());
    CHECK(document.title() != "scene.json");
    document.undo();
    document.redo();
    CHECK(document.is_modified());
    document.redo();
    CHECK(!document.is_modified());
    CHECK(document.history_saved() == document.history_position());
    // Flown away and back.
    Camera camera = active_camera(document.scene());
    const Camera start = camera;
    camera.look_from.x += 1;
    document.fly(camera);
    CHECK(document.is_modified());
    document.fly(start);
    CHECK(!document.is_modified());
    // Another way to the same scene counts as saved; a branch that leaves it behind does not.
    document.undo();
    rename("b");
    CHECK(!document.is_modified());
    document.undo();
    rename("c");
    document.undo();
    CHECK(document.is_modified());
}

TEST_CASE("document: a file saved by another thread meanwhile leaves later edits unsaved") {
    Document document;
    const ScenePtr written = document.snapshot();
    document.edit("Name", "", [](Scene& s) { s.name = "later"; });
    document.mark_saved(written, "scene.json");
    CHECK(document.is_modified());
    CHECK(document.file() == "scene.json");
    document.undo();
    CHECK(!document.is_modified());
}

TEST_CASE("document: a recovered scene is unsaved under its own name") {
    Document document;
    Scene scene = document.scene();
    scene.name = "from before";
    document.recover(scene, "mine.json");
    CHECK(document.is_modified());
    CHECK(document.file() == "mine.json");
    document.edit("Name", "", [](Scene& s) { s.name = std::string("x"); });
    document.undo();
    CHECK(document.is_modified());
}

TEST_CASE("document: errors of opening and saving leave it as it was") {
    TemporaryFolder folder;
    Document document;
    document.edit("Name", "", [](Scene& s) { s.name = "kept"; });
    document.select(document.scene().objects.front().id);
    const ScenePtr before = document.snapshot();
    const auto is_as_before = [&] {
        return document.snapshot() == before && document.history().size() == 2 &&
               document.is_modified() && document.file().empty() && document.selection.size() == 1;
    };
    CHECK_THROWS_AS(document.open(folder.path / "missing.json"), Error);
    CHECK(is_as_before());
    std::ofstream(folder.path / "broken.json") << "{\"cameras\": [";
    CHECK_THROWS_AS(document.open(folder.path / "broken.json"), Error);
    CHECK(is_as_before());
    CHECK_THROWS_AS(document.save(folder.path / "no" / "folder.json"), Error);
    CHECK(is_as_before());
}
