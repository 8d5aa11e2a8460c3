// What the window keeps on disk and reads from it: settings, layouts, lists of folders.
#include "app/dialogs/folder_list.h"
#include "app/layout_file.h"
#include "app/preferences.h"
#include "support/temporary_folder.h"

#include <teapath/core/error.h>

#include <doctest/doctest.h>

#include <fstream>

using namespace tp;
using tp::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

void write(const fs::path& file, const std::string& text = "x") {
    std::ofstream(file) << text;
}

std::vector<std::string> names(const std::vector<FolderEntry>& entries) {
    std::vector<std::string> list;
    for (const FolderEntry& entry : entries)
        list.push_back(entry.name);
    return list;
}

}  // namespace

TEST_CASE("preferences: come back as they were written") {
    TemporaryFolder folder;
    Preferences p;
    p.dark_theme = false;
    p.interface_scale = 1.5f;
    p.autosave_minutes = 7;
    p.native_dialogs = false;
    p.window = {10, -20, 1280, 720, true};
    p.folders = {{"scene", "/a b"}, {"image", "/c"}};
    p.set_panel_open("Console", false);
    p.set_panel_open("Console", false);
    p.remember_file("/tmp/one.json");
    p.remember_file("/tmp/two.json");
    p.remember_file("/tmp/one.json");
    CHECK(p.recent_files == std::vector<std::string>{"/tmp/one.json", "/tmp/two.json"});
    save_preferences(p, folder.path / "settings.json");
    CHECK(load_preferences(folder.path / "settings.json") == p);
    CHECK(folder.count() == 1);
    CHECK(!p.is_panel_open("Console"));
    CHECK(p.is_panel_open("Metrics"));
    p.set_panel_open("Console", true);
    CHECK(p.closed_panels.empty());
}

TEST_CASE("preferences: broken, missing and foreign values give the defaults") {
    TemporaryFolder folder;
    const fs::path file = folder.path / "settings.json";
    CHECK(load_preferences(file) == Preferences{});
    write(file, "{ not json");
    CHECK(load_preferences(file) == Preferences{});
    write(file, "[1, 2]");
    CHECK(load_preferences(file) == Preferences{});
    write(file, R"({"dark_theme": "yes", "window": [1, 2, 0, 4, 5], "interface_scale": 99,
                    "autosave_minutes": -3, "closed_panels": 7, "folders": [], "new": 1})");
    Preferences p = load_preferences(file);
    CHECK(p.interface_scale == 3);
    CHECK(p.autosave_minutes == 0);
    p.interface_scale = 0;
    p.autosave_minutes = Preferences{}.autosave_minutes;
    CHECK(p == Preferences{});
}

TEST_CASE("preferences: the recent list is bounded") {
    Preferences p;
    for (int i = 0; i < 40; ++i)
        p.remember_file("/tmp/" + std::to_string(i) + ".json");
    CHECK(p.recent_files.size() == Preferences::kMaxRecent);
    CHECK(p.recent_files.front() == "/tmp/39.json");
}

TEST_CASE("layouts: saved, listed, read, replaced and deleted, whatever their names") {
    TemporaryFolder folder;
    const fs::path layouts = folder.path / "layouts";
    CHECK(layout_names(layouts).empty());
    const std::vector<std::string> wanted = {"../up", "Fl\xc3\xa4 2", "a/b", "plain"};
    for (const std::string& name : wanted) {
        const Layout layout{name, {"Console", "History"}, "[Window][Options]\nPos=1,2\n\n"};
        save_layout(layouts, layout);
        CHECK(load_layout(layouts, name) == layout);
    }
    CHECK(layout_names(layouts) == wanted);
    CHECK(folder.count() == 1);  // nothing beside the folder
    save_layout(layouts, {"plain", {}, "new"});
    CHECK(load_layout(layouts, "plain").places == "new");
    CHECK(layout_names(layouts).size() == 4);
    delete_layout(layouts, "a/b");
    CHECK(layout_names(layouts).size() == 3);
    CHECK_THROWS_AS(load_layout(layouts, "a/b"), Error);
    CHECK_THROWS_AS(delete_layout(layouts, "a/b"), Error);
    write(layouts / "broken.json", "{}");
    CHECK(layout_names(layouts).size() == 3);
    CHECK_THROWS_AS(load_layout(layouts, "broken"), Error);
}

TEST_CASE("layouts: names that cannot be taken") {
    CHECK(why_no_layout_name("Evening") == "");
    for (const char* name : {"", "   ", "Edit", "Render", "Inspect"})
        CHECK(why_no_layout_name(name) != "");
    CHECK(why_no_layout_name(std::string(100, 'a')) != "");
}

TEST_CASE("folder list: filter, order of people, hidden files, errors") {
    TemporaryFolder folder;
    for (const char* name :
         {"b10.json", "b2.JSON", "a.json", "note.txt", ".hidden.json", "B3.json"})
        write(folder.path / name);
    write(folder.path / "big.json", std::string(5000, 'x'));
    fs::create_directories(folder.path / "zoo");
    fs::create_directories(folder.path / "Ant");
    const FileFilter scenes{"Scenes", {".json"}};
    std::string error;
    auto entries = list_folder(folder.path, scenes, false, error);
    CHECK(error.empty());
    sort_entries(entries, FolderOrder::Name, false);
    CHECK(names(entries) == std::vector<std::string>{"Ant", "zoo", "a.json", "b2.JSON", "B3.json",
                                                     "b10.json", "big.json"});
    sort_entries(entries, FolderOrder::Bytes, true);
    CHECK(entries[0].is_folder);
    CHECK(entries[2].name == "big.json");
    CHECK(list_folder(folder.path, scenes, true, error).size() == 8);
    CHECK(list_folder(folder.path, {}, true, error).size() == 9);
    CHECK(list_folder(folder.path / "missing", {}, true, error).empty());
    CHECK(!error.empty());
    CHECK(scenes.label() == "Scenes (*.json)");
}

TEST_CASE("folder list: typed paths and sizes") {
    CHECK(typed_path("a.json", "/x/y") == "/x/y/a.json");
    CHECK(typed_path("../a.json", "/x/y") == "/x/a.json");
    CHECK(typed_path("/z", "/x/y") == "/z");
    CHECK(typed_path("~", "/x").is_absolute());
    CHECK(bytes_text(0) == "0 B");
    CHECK(bytes_text(1536) == "1.5 KiB");
    CHECK(bytes_text(uintmax_t{300} << 20) == "300 MiB");
}
