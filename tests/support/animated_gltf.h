// A small glTF file with a triangle that moves and turns, one that morphs and one with a skin.
#pragma once

#include "gltf_files.h"

#include <string>

namespace tp::test {

/// Nodes: 0 "mover" (animation "slide" takes it from x = 0 to x = 4 in 2 seconds), 1 "turner",
/// below it, at y = 1 ("spin" turns it by 90 degrees about z in 1 second, CUBICSPLINE in whole
/// numbers), 2 "morpher" ("morph" goes from weight 0 to 1 in 1 second; the target lifts z by 1), 3
/// "skinned" with joints 4 and 5 ("bend" lifts joint 5 by 3 at second 1, STEP). Broken and
/// unsupported channels are there too.
inline std::string animated_json(const std::string& more_animations = "") {
    GltfBuffer b;
    b.add(bytes_of_list<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}));                  // 0 positions
    b.add(bytes_of_list<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}));                  // 1 target
    b.add(bytes_of_list<uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}));       // 2 joints
    b.add(bytes_of_list<float>({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}));   // 3 weights
    b.add(bytes_of_list<float>({0, 2}));                                       // 4 times
    b.add(bytes_of_list<float>({0, 0, 0, 4, 0, 0}));                           // 5 slide
    b.add(bytes_of_list<float>({0, 1}));                                       // 6 times
    b.add(bytes_of_list<int16_t>({0, 0, 0, 0, 0, 0, 0,     32767, 0, 0, 0, 0,  // 7 spin
                                  0, 0, 0, 0, 0, 0, 23170, 23170, 0, 0, 0, 0}));
    b.add(bytes_of_list<uint8_t>({0, 255}));          // 8 morph
    b.add(bytes_of_list<float>({0, 0, 0, 0, 3, 0}));  // 9 bend
    const auto accessor = [](int view, int type, int count, const char* kind, bool normalized) {
        return "{\"bufferView\": " + std::to_string(view) +
               ", \"componentType\": " + std::to_string(type) +
               ", \"count\": " + std::to_string(count) + ", \"type\": \"" + kind + "\"" +
               (normalized ? ", \"normalized\": true}" : "}");
    };
    const std::string accessors =
        accessor(0, 5126, 3, "VEC3", false) + "," + accessor(1, 5126, 3, "VEC3", false) + "," +
        accessor(2, 5121, 3, "VEC4", false) + "," + accessor(3, 5126, 3, "VEC4", false) + "," +
        accessor(4, 5126, 2, "SCALAR", false) + "," + accessor(5, 5126, 2, "VEC3", false) + "," +
        accessor(6, 5126, 2, "SCALAR", false) + "," + accessor(7, 5122, 6, "VEC4", true) + "," +
        accessor(8, 5121, 2, "SCALAR", true) + "," + accessor(9, 5126, 2, "VEC3", false);
    const auto animation = [](const char* name, int node, const char* path, int input, int output,
                              const char* rule) {
        return std::string("{\"name\": \"") + name +
               "\", \"channels\": [{\"sampler\": 0, \"target\": {\"node\": " +
               std::to_string(node) + ", \"path\": \"" + path +
               "\"}}], \"samplers\": [{\"input\": " + std::to_string(input) +
               ", \"output\": " + std::to_string(output) + ", \"interpolation\": \"" + rule +
               "\"}]}";
    };
    return b.json() + ", \"accessors\": [" + accessors + R"(],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]},
                   {"primitives": [{"attributes": {"POSITION": 0}, "targets": [{"POSITION": 1}]}]},
                   {"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 2, "WEIGHTS_0": 3}}]}],
        "skins": [{"joints": [4, 5]}],
        "nodes": [{"name": "mover", "mesh": 0, "children": [1]},
                  {"name": "turner", "mesh": 0, "translation": [0, 1, 0]},
                  {"name": "morpher", "mesh": 1, "translation": [0, 0, 5]},
                  {"name": "skinned", "mesh": 2, "skin": 0},
                  {"name": "root joint", "children": [5]}, {"name": "tip joint"}],
        "scenes": [{"nodes": [0, 2, 3, 4]}],
        "animations": [)" +
           animation("slide", 0, "translation", 4, 5, "LINEAR") + "," +
           animation("spin", 1, "rotation", 6, 7, "CUBICSPLINE") + "," +
           animation("morph", 2, "weights", 6, 8, "LINEAR") + "," +
           animation("bend", 5, "translation", 6, 9, "STEP") + more_animations + "]";
}

}  // namespace tp::test
