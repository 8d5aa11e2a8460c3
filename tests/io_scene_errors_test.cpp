// Scene files that are wrong: the message names the file, the place in the JSON and the remedy.
#include <teapath/core/error.h>
#include <teapath/io/scene_file.h>
#include <teapath/scene/validate.h>

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

using namespace tp;
namespace fs = std::filesystem;

namespace {

using Parts = std::vector<std::string>;

void check_parts(const Error& error, const Parts& parts) {
    const std::string message = error.what();
    CAPTURE(message);
    CHECK(error.kind() == ErrorKind::Input);
    CHECK(error.exit_code() == 3);
    CHECK(!error.remedy().empty());
    for (const std::string& part : parts) {
        CAPTURE(part);
        CHECK(message.find(part) != std::string::npos);
    }
}

// `text` is refused, with each part in the message.
void refused(const std::string& text, const Parts& parts) {
    const std::string start = text.substr(0, 200);
    CAPTURE(start);
    try {
        parse_scene(text, ".", "test.json");
        FAIL_CHECK("no error");
    } catch (const Error& error) {
        check_parts(error, parts);
        CHECK(error.where().rfind("test.json", 0) == 0);
    }
}

// The scene `{"teapath": 1, <keys>}` is refused.
void refused_keys(const std::string& keys, const Parts& parts) {
    refused(R"({"teapath": 1, )" + keys + "}", parts);
}

// A scene with a sphere and <keys> beside its shape is refused.
void refused_object(const std::string& keys, const Parts& parts) {
    refused_keys(R"("objects": [{"shape": {"type": "sphere"}, )" + keys + "}]", parts);
}

void refused_material(const std::string& material, const Parts& parts) {
    refused_keys(R"("materials": {"paint": )" + material + "}", parts);
}

void refused_file(const fs::path& file, const Parts& parts) {
    CAPTURE(file.string());
    try {
        load_scene(file);
        FAIL_CHECK("no error");
    } catch (const Error& error) {
        check_parts(error, parts);
        CHECK(error.where() == file.string());
    }
}

class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "teapath_XXXXXX").string();
        REQUIRE(mkdtemp(name.data()));
        path = name;
    }
    ~TemporaryFolder() { fs::remove_all(path); }
    fs::path path;
};

}  // namespace

TEST_CASE("scene errors: files that cannot be read") {
    const TemporaryFolder folder;
    refused_file(folder.path / "none.json", {"no such file", "check the path"});
    refused_file(folder.path, {"this is a folder", "name a scene file"});
    refused_file(folder.path / std::string(300, 'x'), {"cannot be opened"});
    refused_file("/dev/null", {"empty", "docs/scene_format.md"});
    std::ofstream(folder.path / "secret.json") << "{}";
    ::chmod((folder.path / "secret.json").c_str(), 0);
    if (::geteuid() != 0)
        refused_file(folder.path / "secret.json", {"Permission denied", "check its permissions"});
}

TEST_CASE("scene errors: text that is no JSON, with line and column") {
    refused("", {"empty"});
    refused(" \n\t ", {"empty"});
    refused("{\n  \"teapath\": 1,\n  \"name\": oops\n}", {"not valid JSON at line 3, column 11"});
    refused("{\"teapath\": 1,\n \"objects\": [", {"line 2", "missing comma, quote or bracket"});
    refused_keys(R"("name": "open)", {"line 1"});
    refused_keys(R"("render": {"width": NaN})",
                 {"not valid JSON", "NaN and infinity are not JSON"});
    refused_keys(R"("render": {"width": -Infinity})", {"not valid JSON"});
    refused_keys(R"("display": {"exposure": 1e400})", {"the number 1e400 is too large at line 1"});
    refused_keys(R"("display": {"exposure": -1e400})", {"the number -1e400 is too large"});
    refused_keys("\"name\": \"\xff\"", {"not valid JSON"});
    refused("{\"teapath\": 1} {}", {"not valid JSON"});
    refused(std::string(1000000, '['), {"nest deeper than 200 levels at line 1, column 201"});
    std::string deep;
    for (int i = 0; i < 300; ++i)
        deep += R"({"type": "checker", "even": )";
    refused_keys("\"textures\": {\"a\": " + deep, {"nest deeper"});
    std::mt19937 random(7);
    std::string noise(1 << 20, ' ');
    for (char& c : noise)
        c = static_cast<char>(random());
    refused(noise, {});
}

TEST_CASE("scene errors: keys") {
    refused("[]", {"expected an object, found a list"});
    refused("null", {"expected an object, found null"});
    refused("{}", {"\"teapath\" is missing", "add \"teapath\": 1"});
    refused(R"({"teapath": 2})", {"version 2 of the format is unknown", "reads version 1"});
    refused(R"({"teapath": "1"})", {"teapath: expected a number, found a string"});
    refused_keys(R"("objcts": [])", {"unknown key \"objcts\"", "did you mean \"objects\"?"});
    refused_keys(R"("zzzzzzzz": 1)", {"unknown key", "known: teapath, name, description, camera"});
    refused_keys(R"("render": {"smaples": 1})", {"test.json: render: ", "mean \"samples\"?"});
    refused_keys(R"("render": {"width": 1, "width": 2})", {"render.width", "stands twice"});
    refused_object(R"("transform": {"rotate": [0, 0, 0], "rotate": [0, 0, 0]})",
                   {"objects[0].transform.rotate", "stands twice", "remove one"});
    refused_object(R"("materail": "red")", {"objects[0]: ", "mean \"material\"?"});
    refused_material(R"({"type": "lambertian", "fuzz": 0.2})",
                     {"materials.paint: unknown key \"fuzz\""});
    refused_keys(R"("camera": {}, "cameras": [])", {"both \"camera\" and \"cameras\""});
    refused_keys(R"("materials": {"": {"type": "metal"}})", {"materials: a name is empty"});
}

TEST_CASE("scene errors: types") {
    refused_keys(R"("render": {"width": "8"})",
                 {"render.width: expected a number, found a string"});
    refused_keys(R"("render": {"width": null})", {"render.width: expected a number, found null"});
    refused_keys(R"("render": {"width": 8.5})",
                 {"render.width: expected a whole number, found 8.5"});
    refused_keys(R"("render": {"width": 1e30})", {"render.width: expected a whole number"});
    refused_keys(R"("render": {"seed": -1})", {"render.seed: expected a whole number", "from 0"});
    refused_keys(R"("render": {"light_sampling": 1})", {"expected true or false, found a number"});
    refused_keys(R"("render": [])", {"render: expected an object, found a list"});
    refused_keys(R"("objects": {})", {"objects: expected a list, found an object"});
    refused_keys(R"("objects": [3])", {"objects[0]: expected an object, found a number"});
    refused_keys(R"("textures": [])", {"textures: expected an object of textures by name"});
    refused_keys(R"("name": 3)", {"name: expected a string, found a number"});
    refused_keys(R"("camera": {"look_at": [0, 1]})",
                 {"camera.look_at", "3 numbers, found one of 2"});
    refused_keys(R"("camera": {"look_at": [0, 1, "z"]})", {"camera.look_at[2]: expected a number"});
    refused_keys(R"("background": {"type": "constant", "color": true})",
                 {"background.color: expected a colour, found true or false", "#rrggbb"});
    refused_material(R"({"type": "metal", "color": "#12345g"})",
                     {"materials.paint.color: expected a colour, found \"#12345g\""});
    refused_material(R"({"type": "principled", "metallic": "wood"})",
                     {"materials.paint.metallic: expected a number, found a string"});
    refused_material(R"({"type": "principled", "coat": {"value": 1}})",
                     {"materials.paint.coat: the key \"texture\" is missing"});
    refused_material(R"({"type": "principled", "coat": {"texture": "wood"}})",
                     {"materials.paint.coat.texture: unknown texture \"wood\""});
    refused_material(R"({"type": "principled", "normal": 1})",
                     {"materials.paint.normal: expected a texture or the name of one"});
    refused_object(R"("material": 3)", {"objects[0].material: expected a material or the name"});
}

TEST_CASE("scene errors: names") {
    refused_keys(R"("render": {"integrator": "paht"})", {"render.integrator", "mean \"path\"?"});
    refused_keys(R"("background": {"type": "heaven"})",
                 {"background.type: unknown value \"heaven\""});
    refused_keys(R"("background": {})", {"\"type\" is missing", "gradient, constant, image"});
    refused_keys(R"("background": {"type": "image"})", {"background", "\"file\" is missing"});
    refused_keys(R"("objects": [{}])", {"objects[0]: the key \"shape\" is missing", "for example"});
    refused_keys(R"("objects": [{"shape": {}}])", {"objects[0].shape", "one of: sphere, xy_rect"});
    refused_keys(R"("objects": [{"shape": {"type": "spehre"}}])", {"mean \"sphere\"?"});
    refused_object(R"("material": "gold")", {"unknown material \"gold\"", "none in this file"});
    refused_keys(R"("materials": {"gold": {"type": "metal"}},
                    "objects": [{"shape": {"type": "box"}, "material": "glod"}])",
                 {"objects[0].material: unknown material \"glod\"", "mean \"gold\"?"});
    refused_material(R"({"type": "metal", "color": "wood"})", {"unknown texture \"wood\""});
    refused_keys(R"("cameras": [{"name": "left"}], "active_camera": "lift")",
                 {"active_camera: unknown camera \"lift\"", "mean \"left\"?"});
    refused_keys(R"("cameras": [{"name": "a"}, {"name": "a"}])", {"\"a\" is used twice", "rename"});
    refused_keys(R"("generate": [{"type": "spheres"}])", {"generate[0].type", "sphere_grid"});
}

TEST_CASE("scene errors: values") {
    refused_keys(R"("render": {"width": -4})", {"render.width: -4 is out of range", "1 to 65536"});
    refused_keys(R"("render": {"height": 0})", {"render.height: 0 is out of range"});
    refused_keys(R"("render": {"width": 100000, "height": 100000})", {"render.width: 100000"});
    refused_keys(R"("render": {"width": 60000, "height": 60000})", {"too many", "16384 x 16384"});
    refused_keys(R"("camera": {"vertical_fov": 0})", {"camera.vertical_fov", "above 0 and below"});
    refused_keys(R"("camera": {"vertical_fov": 180})", {"camera.vertical_fov: 180 degrees"});
    refused_keys(R"("camera": {"look_from": [1, 2, 3], "look_at": [1, 2, 3]})",
                 {"camera.look_at: the camera looks at where it is", "move look_from"});
    refused_keys(R"("cameras": [{}, {"look_from": [0, 5, 0]}])",
                 {"cameras[1].up: up is parallel to the view", "take [0, 0, -1]"});
    refused_keys(R"("textures": {"a": {"type": "checker", "even": "a"}})",
                 {"textures.a: the texture contains itself", "break the circle"});
    refused_keys(R"("textures": {"a": {"type": "checker", "even": "b"},
                                 "b": {"type": "checker", "odd": {"type": "checker", "odd": "a"}}})",
                 {"textures.", "contains itself"});
    refused_material(R"({"type": "metal", "fuzz": 1.5})", {"materials.paint.fuzz", "from 0 to 1"});
    refused_material(R"({"type": "dielectric", "ior": 0})",
                     {"materials.paint.ior", "out of range"});
    refused_material(R"({"type": "lambertian", "opacity": 2})", {"materials.paint.opacity"});
    refused_material(R"({"type": "lambertian", "color": [0, -1, 0]})", {"paint.color", "negative"});
    refused_object(R"("material": {"type": "metal", "fuzz": -1})", {"objects[0].material.fuzz"});
    refused_object(R"("transform": {"scale": [1, 0, 1]})",
                   {"objects[0].transform.scale", "visible"});
    refused_object(R"("transform": {"translate": [1e300, 0, 0]})", {"translate[0]", "too large"});
    refused_keys(R"("generate": [{"type": "sphere_grid", "columns": 65535, "rows": 65535}])",
                 {"generate[0]", "20 million"});
}

TEST_CASE("scene errors: what is odd but harmless is a warning") {
    const auto warned = [](const std::string& keys) {
        return validate(parse_scene(R"({"teapath": 1, )" + keys + "}", ".", "test.json"));
    };
    for (const char* shape :
         {R"({"type": "sphere", "radius": 0})", R"({"type": "rectangle", "edge_u": [0, 0, 0]})",
          R"({"type": "xz_rect", "low": [1, 0], "high": [1, 1]})"}) {
        CAPTURE(shape);
        const auto problems = warned(std::string(R"("objects": [{"shape": )") + shape + "}]");
        REQUIRE(problems.size() == 1);
        CHECK_FALSE(problems[0].fatal);
        CHECK(problems[0].what.find("never hit") != std::string::npos);
    }
    CHECK(warned(R"("textures": {"a": {"type": "image", "file": "none.png"}})").empty());
    CHECK(warned(R"("textures": {"a": {"type": "image", "file": ""}})").empty());
    CHECK(warned(R"("$schema": "anything", "objects": [])").empty());
}
