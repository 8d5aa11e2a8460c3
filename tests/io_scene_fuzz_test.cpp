// Scenes cut short, with bytes flipped, with values replaced by others: refused with a message or
// loaded, never a crash; what is loaded can be flattened, and saved and loaded again.
#include "support/shipped_scenes.h"

#include <teapath/core/error.h>
#include <teapath/device/scene_arrays.h>
#include <teapath/io/scene_file.h>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <random>

using namespace tp;
using nlohmann::ordered_json;

namespace {

// A scene with everything in it but images.
const char* const kEverything = R"({"teapath": 1, "name": "all",
  "cameras": [{"name": "a"}, {"name": "b", "aperture": 0.1, "near_clip": 1, "far_clip": 5}],
  "active_camera": "b", "render": {"width": 8, "height": 8, "seed": 3, "sampler": "sobol"},
  "display": {"exposure": 1.5}, "background": {"type": "constant", "color": "#123456"},
  "textures": {"t": {"type": "checker", "even": "u", "odd": {"type": "constant"}},
               "u": {"type": "checker", "mode": "world", "frequency": 3}},
  "materials": {"m": {"type": "lambertian", "color": "t"},
                "n": {"type": "diffuse_light", "emission": "u", "strength": 2, "side": "both"}},
  "objects": [
    {"shape": {"type": "sphere", "radius": -1}, "transform": {"scale": [1, 2, 3]}, "material": "m"},
    {"shape": {"type": "xy_rect", "k": 1}, "material": "n"}, {"shape": {"type": "xz_rect"}},
    {"shape": {"type": "yz_rect"}, "transform": {"rotate": [1, 2, 3], "translate": [4, 5, 6]}},
    {"shape": {"type": "rectangle"}, "material": {"type": "metal", "fuzz": 0.5}},
    {"shape": {"type": "box"}, "material": {"type": "dielectric", "opacity": 0.5}},
    {"shape": {"type": "disk"}, "material": "n", "inside_out": true},
    {"shape": {"type": "triangle"}, "material": {"type": "metal", "emission": [1, 2, 3]}}],
  "generate": [{"type": "sphere_grid", "columns": 3, "rows": 2, "keep_clear": [[0, 0, 0, 1]]}]})";

// True if the text was taken for a scene; then the scene is used in every way.
bool try_scene(const std::string& text) {
    try {
        const Scene scene = parse_scene(text, ".", "fuzz");
        if (expand_generators(scene).objects.size() < 10000) {
            SceneArrays arrays;
            flatten(scene, SceneParts::All, arrays);
        }
        const std::string saved = scene_text(scene);
        CHECK(scene_text(parse_scene(saved, ".", "saved")) == saved);
        return true;
    } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::Input);
        CHECK(!error.where().empty());
        return false;
    }
}

// Every value of the tree, by way of pointers to them.
void collect(ordered_json& json, std::vector<ordered_json*>& values) {
    values.push_back(&json);
    if (json.is_structured())
        for (auto& child : json)
            collect(child, values);
}

}  // namespace

TEST_CASE("scene fuzz: cut at every byte") {
    const std::string good = kEverything;
    REQUIRE(try_scene(good));
    for (size_t length = 0; length < good.size(); ++length)
        CHECK_FALSE(try_scene(good.substr(0, length)));
}

TEST_CASE("scene fuzz: bytes flipped, doubled, left out") {
    std::mt19937 random(11);
    for (int i = 0; i < 3000; ++i) {
        std::string text = kEverything;
        for (unsigned changes = 1 + random() % 4; changes > 0; --changes) {
            const size_t at = random() % text.size();
            switch (random() % 4) {
                case 0: text[at] = static_cast<char>(random()); break;
                case 1: text[at] = "0123456789-+.eE{}[]\",: "[random() % 23]; break;
                case 2: text.erase(at, 1 + random() % 5); break;
                default: text.insert(at, text.substr(random() % text.size(), random() % 20));
            }
        }
        try_scene(text);
    }
}

TEST_CASE("scene fuzz: values replaced by odd ones") {
    const std::vector<ordered_json> odd = {nullptr,
                                           true,
                                           0,
                                           -1,
                                           1,
                                           0.5,
                                           1e15,
                                           -1e15,
                                           1e-15,
                                           1e-300,
                                           1e300,
                                           5e-324,
                                           2147483648.0,
                                           18446744073709551615u,
                                           65536,
                                           "",
                                           "t",
                                           "m",
                                           "n",
                                           "#fff",
                                           "path",
                                           "book",
                                           "image",
                                           ordered_json::array(),
                                           ordered_json::object(),
                                           {0, 0, 0},
                                           {1e15, -1e15, 1e15},
                                           {1e-15, 1e-15, 1e-15},
                                           {0, 0, 0, 0},
                                           {1, 1}};
    std::mt19937 random(12);
    int loaded = 0;
    for (int i = 0; i < 6000; ++i) {
        ordered_json json = ordered_json::parse(kEverything);
        for (unsigned changes = 1 + random() % 3; changes > 0; --changes) {
            std::vector<ordered_json*> values;
            collect(json, values);
            *values[1 + random() % (values.size() - 1)] = odd[random() % odd.size()];
            if (!json.is_object() || json.empty()) break;
        }
        loaded += try_scene(json.dump());
    }
    // Enough get through to have tried what comes after reading.
    CHECK(loaded > 200);
}
