// What a crash leaves and what a clean end does not: autosaved files, found by the next start once
// the process that wrote them is gone.
#include "support/temporary_folder.h"

#include <teapath/core/error.h>
#include <teapath/editor/document.h>
#include <teapath/editor/recovery.h>
#include <teapath/io/scene_file.h>

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

using namespace tp;
using tp::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

Scene named(const std::string& name) {
    Scene scene = Document().scene();
    scene.name = name;
    return scene;
}

// A process that autosaves and is killed before it could clean up.
void crash_with(const fs::path& folder, const std::string& name, const fs::path& original) {
    const pid_t child = fork();
    if (child == 0) {
        AutosaveFile file(folder);
        file.write(named(name), original, file.ticket());
        kill(getpid(), SIGKILL);
    }
    REQUIRE(child > 0);
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFSIGNALED(status));
}

}  // namespace

TEST_CASE("recovery: a killed process leaves its scene, with the file that it belongs to") {
    TemporaryFolder folder;
    crash_with(folder.path, "lost", "/home/me/my scene.json");
    const auto leftovers = find_leftovers(folder.path);
    REQUIRE(leftovers.size() == 1);
    CHECK(leftovers[0].original == "/home/me/my scene.json");
    CHECK(load_scene(leftovers[0].scene) == named("lost"));
    const auto age = std::chrono::system_clock::now() - leftovers[0].time;
    CHECK(age < std::chrono::minutes(1));
    // Offered by one program at a time.
    CHECK(find_leftovers(folder.path).empty());
    leftovers[0].discard();
    CHECK(folder.count() == 0);
}

TEST_CASE(
    "recovery: several leftovers, an unnamed scene among them, stay until they are discarded") {
    TemporaryFolder folder;
    crash_with(folder.path, "one", "");
    crash_with(folder.path, "two", "two.json");
    CHECK(find_leftovers(folder.path).size() == 2);
    const auto leftovers = find_leftovers(folder.path);
    REQUIRE(leftovers.size() == 2);
    for (const Leftover& leftover : leftovers)
        CHECK((load_scene(leftover.scene).name == "one") == leftover.original.empty());
}

TEST_CASE("recovery: a running process' file is no leftover, a clean end leaves nothing") {
    TemporaryFolder folder;
    {
        AutosaveFile file(folder.path / "made" / "for it");
        CHECK(find_leftovers(folder.path / "made" / "for it").empty());
        file.write(named("open"), "a.json", file.ticket());
        CHECK(find_leftovers(folder.path / "made" / "for it").empty());
    }
    CHECK(fs::is_empty(folder.path / "made" / "for it"));
}

TEST_CASE(
    "recovery: saving takes the file away, and a write that was under way does not bring it back") {
    TemporaryFolder folder;
    AutosaveFile file(folder.path);
    const uint64_t ticket = file.ticket();
    file.write(named("a"), "a.json", ticket);
    CHECK(folder.count() == 3);
    file.remove();
    CHECK(folder.count() == 1);  // the lock
    file.write(named("a"), "a.json", ticket);
    CHECK(folder.count() == 1);
    file.write(named("b"), "a.json", file.ticket());
    CHECK(folder.count() == 3);
}

TEST_CASE("recovery: two programs of one user keep apart") {
    TemporaryFolder folder;
    AutosaveFile a(folder.path), b(folder.path);
    a.write(named("a"), "", a.ticket());
    b.write(named("b"), "", b.ticket());
    CHECK(folder.count() == 6);
}

TEST_CASE("recovery: images are found from where the file is kept") {
    TemporaryFolder folder;
    fs::create_directories(folder.path / "mine");
    fs::create_directories(folder.path / "state");
    std::ofstream(folder.path / "mine" / "dot.ppm") << "P6 1 1 255\nabc";
    Scene scene = named("pictures");
    scene.origin.folder = (folder.path / "mine").string();
    scene.background.kind = BackgroundKind::Image;
    scene.background.file.path = "dot.ppm";
    AutosaveFile file(folder.path / "state");
    file.write(scene, folder.path / "mine" / "scene.json", file.ticket());
    for (const auto& entry : fs::directory_iterator(folder.path / "state"))
        if (entry.path().extension() == ".json")
            CHECK(load_scene(entry.path()).background.file.image != nullptr);
}

TEST_CASE("recovery: a folder that cannot be written to is an error with the place") {
    AutosaveFile file("/proc/teapath");
    CHECK_THROWS_WITH_AS(file.write(named("x"), "", file.ticket()), doctest::Contains("/proc"),
                         Error);
    CHECK(find_leftovers("/proc/teapath").empty());
}
