// glTF: geometry of every form, nodes and their paths, cameras, lights, and what is refused.
#include "support/gltf_files.h"

#include <algorithm>
#include <cmath>

using namespace tp;
using namespace tp::test;

namespace {

double difference(const DoubleMat4& a, const DoubleMat4& b) {
    double largest = 0;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            largest = std::max(largest, std::abs(a[c][r] - b[c][r]));
    return largest;
}

std::string numbers(const DoubleMat4& m) {
    std::string text;
    for (int i = 0; i < 16; ++i)
        text += (i ? ", " : "") + std::to_string(m[i / 4][i % 4]);
    return text;
}

}  // namespace

TEST_CASE("gltf: a triangle of a text file and of a container, placed and shared by nodes") {
    const ModelFolder folder;
    const ModelContent text = folder.gltf(triangle_json(
        R"({"mesh": 0, "name": "A", "translation": [1, 2, 3], "scale": [2, 2, 2],
            "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "children": [1]},
           {"mesh": 0})"));
    REQUIRE(text.objects.size() == 2);
    const Object& a = text.objects[0];
    CHECK(a.id.value == 1);
    CHECK(a.name == "A");
    CHECK(a.part.path == "A");
    CHECK(text.objects[1].part.path == "A/node 1");
    CHECK(a.transform.translation == Double3(1, 2, 3));
    CHECK(a.transform.rotation == Double3(0, 0, 90));
    CHECK(a.transform.scale == Double3(2, 2, 2));
    CHECK(text.objects[1].transform == a.transform);
    CHECK(&mesh_of(a) == &mesh_of(text.objects[1]));
    CHECK(mesh_of(a).positions[1] == Float3(1, 0, 0));
    CHECK(mesh_of(a).uvs.at(0)[0] == Float2(0, 1));  // v = 0 is on top in both
    CHECK(mesh_of(a).high == Float3(1, 1, 0));
    // What has no material gets that of the specification.
    REQUIRE(text.materials.size() == 1);
    CHECK(a.material.value == 1);
    CHECK(text.materials[0].kind == MaterialKind::Principled);
    CHECK(text.materials[0].surface.metallic.value == 1);

    GltfBuffer buffer;
    buffer.add(bytes_of_list<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    const ModelContent container = folder.read(
        "b.glb", glb(R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 36}], )" +
                         buffer.views() + R"(, "accessors": [{"bufferView": 0,
            "componentType": 5126, "count": 3, "type": "VEC3"}], "scene": 0,
            "scenes": [{"nodes": [1]}], "nodes": [{"mesh": 0}, {"mesh": 0, "name": "B"}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}]})",
                     buffer.bytes));
    REQUIRE(container.objects.size() == 1);
    CHECK(container.objects[0].part.path == "B");
    CHECK(mesh_of(container.objects[0]).positions[2] == Float3(0, 1, 0));
}

TEST_CASE("gltf: strips, fans, sparse and whole-number accessors, interleaved and not") {
    const ModelFolder folder;
    GltfBuffer buffer;
    // Four corners, signed 16 bits normalised, 8 bytes apart.
    buffer.add(
        bytes_of_list<int16_t>({0, 0, 0, 9, 32767, 0, 0, 9, 0, 32767, 0, 9, -32768, 32767, 0, 9}),
        8);
    buffer.add(bytes_of_list<uint8_t>({0, 1, 2, 3}));
    buffer.add(bytes_of_list<uint8_t>({255, 0, 0, 51, 0, 255, 0, 255, 0, 0, 255, 255, 0, 0, 0, 0}));
    buffer.add(bytes_of_list<uint16_t>({1}));     // sparse index
    buffer.add(bytes_of_list<float>({5, 6, 7}));  // and its value
    buffer.add(bytes_of_list<uint32_t>({0, 1, 2}));
    const std::string accessors = R"("accessors": [
        {"bufferView": 0, "componentType": 5122, "normalized": true, "count": 4, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5121, "count": 4, "type": "SCALAR"},
        {"bufferView": 2, "componentType": 5121, "normalized": true, "count": 4, "type": "VEC4"},
        {"componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": 1,
            "indices": {"bufferView": 3, "componentType": 5123},
            "values": {"bufferView": 4}}},
        {"bufferView": 5, "componentType": 5125, "count": 3, "type": "SCALAR"}])";
    const ModelContent content = folder.gltf(buffer.json() + ", " + accessors + R"(,
        "meshes": [{"primitives": [
            {"attributes": {"POSITION": 0, "COLOR_0": 2}, "indices": 1, "mode": 5},
            {"attributes": {"POSITION": 0}, "mode": 6},
            {"attributes": {"POSITION": 3}, "indices": 4},
            {"attributes": {"POSITION": 0}, "mode": 1},
            {"attributes": {"POSITION": 0}, "mode": 0}]}],
        "nodes": [{"mesh": 0, "name": "M"}])");
    REQUIRE(content.objects.size() == 3);
    CHECK(content.objects[2].part.path == "M.3");
    const Mesh& strip = mesh_of(content.objects[0]);
    REQUIRE(strip.triangles.size() == 2);
    CHECK(strip.triangles[0] == std::array<uint32_t, 3>{0, 1, 2});
    CHECK(strip.triangles[1] == std::array<uint32_t, 3>{2, 1, 3});
    CHECK(strip.positions[3] == Float3(-1, 1, 0));
    CHECK(strip.colors[0] == Float4(1, 0, 0, 0.2f));
    CHECK(mesh_of(content.objects[1]).triangles[1] == std::array<uint32_t, 3>{0, 2, 3});
    const Mesh& sparse = mesh_of(content.objects[2]);
    CHECK(sparse.positions[0] == Float3(0));
    CHECK(sparse.positions[1] == Float3(5, 6, 7));
    REQUIRE(content.unsupported.size() == 1);
    CHECK(says(content.unsupported[0], "2 primitives"));
}

TEST_CASE("gltf: any matrix is a transform and a shear, mirrors included") {
    const ModelFolder folder;
    DoubleMat4 shear(1), mirror(1), turned(1);
    shear[1] = Double4(0.5, 2, 0.25, 0);
    shear[3] = Double4(1, 2, 3, 1);
    mirror[0][0] = -2;
    Transform t;
    t.rotation = {20, -75, 130};
    t.scale = {1, 2, 3};
    t.translation = {4, 5, 6};
    turned = world_from_object(t);
    const ModelContent content = folder.gltf(triangle_json(
        R"({"mesh": 0, "matrix": [)" + numbers(shear) + R"(]}, {"mesh": 0, "matrix": [)" +
        numbers(mirror) + R"(]}, {"mesh": 0, "matrix": [)" + numbers(turned) +
        R"(]}, {"mesh": 0, "scale": [1, 0, 1]})"));
    REQUIRE(content.objects.size() == 3);
    CHECK(difference(placed(content.objects[0]), shear) < 1e-5);
    CHECK(std::get<MeshShape>(content.objects[0].shape).placement != DoubleMat3(1));
    CHECK(difference(placed(content.objects[1]), mirror) < 1e-5);
    CHECK(content.objects[1].transform.scale == Double3(-2, 1, 1));
    CHECK(difference(placed(content.objects[2]), turned) < 1e-5);
    CHECK(std::get<MeshShape>(content.objects[2].shape).placement == DoubleMat3(1));
    REQUIRE(content.unsupported.size() == 1);  // the one without volume
}

TEST_CASE("gltf: paths differ, and say the same whenever the file is read") {
    const ModelFolder folder;
    const std::string json = triangle_json(
        R"({"children": [1, 2, 3], "name": "Car"}, {"mesh": 0, "name": "Wheel"},
           {"mesh": 0, "name": "Wheel"}, {"mesh": 0, "name": "a/b"}, {"mesh": 0},
           {"mesh": 0, "name": "Wheel"})");
    const ModelContent content = folder.gltf(json);
    std::vector<std::string> paths;
    for (const Object& object : content.objects)
        paths.push_back(object.part.path);
    CHECK(paths ==
          std::vector<std::string>{"Car/Wheel", "Car/Wheel 2", "Car/a_b", "node 4", "Wheel"});
    CHECK(folder.gltf(json).objects == content.objects);
}

TEST_CASE("gltf: cameras look at the model, lights keep their numbers") {
    const ModelFolder folder;
    const ModelContent content = folder.gltf(triangle_json(
        R"({"mesh": 0}, {"name": "Eye", "camera": 0, "translation": [0, 0, 5]},
           {"camera": 1}, {"name": "Lamp", "extensions": {"KHR_lights_punctual": {"light": 0}}})",
        "", R"(, "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}},
            {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1.5, "zfar": 2,
             "znear": 1}}], "extensionsUsed": ["KHR_lights_punctual"],
            "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "intensity": 7,
            "color": [1, 0.5, 0], "range": 3, "spot": {"outerConeAngle": 0.5}}]}})"));
    REQUIRE(content.cameras.size() == 2);
    CHECK(content.cameras[1].projection == ProjectionKind::Orthographic);
    CHECK(content.cameras[1].film_height == 3);
    const Camera& eye = content.cameras[0];
    CHECK(eye.name == "Eye");
    CHECK(eye.look_from == Double3(0, 0, 5));
    CHECK(eye.look_at == Double3(0, 0, 0));
    CHECK(eye.up == Double3(0, 1, 0));
    CHECK(eye.vertical_fov == doctest::Approx(0.5 * 180 / 3.14159265358979));
    REQUIRE(content.lights.size() == 1);
    CHECK(content.lights[0].kind == ModelLight::Kind::Spot);
    CHECK(content.lights[0].intensity == 7);
    CHECK(content.lights[0].range == 3);
    CHECK(content.lights[0].color == Double3(1, 0.5, 0));
    CHECK(content.lights[0].outer_cone == doctest::Approx(28.6479));
    CHECK(content.unsupported.empty());
}

TEST_CASE("gltf: what is broken is refused with a sentence") {
    const ModelFolder folder;
    const auto changed = [](std::string text, const std::string& from, const std::string& to) {
        REQUIRE(text.find(from) != std::string::npos);
        return text.replace(text.find(from), from.size(), to);
    };
    const std::string good = triangle_json(R"({"mesh": 0})");
    CHECK(folder.gltf_refusal(good) == "not refused");

    // The tree.
    CHECK(says(folder.gltf_refusal(triangle_json(R"({"children": [1]}, {"children": [0]})", "",
                                                 R"(, "scenes": [{"nodes": [0]}])")),
               "below itself"));
    CHECK(says(
        folder.gltf_refusal(triangle_json(R"({"children": [2]}, {"children": [2]}, {"mesh": 0})")),
        "two parents"));
    CHECK(says(folder.gltf_refusal(triangle_json(R"({"children": [7]})")), "no node 7"));
    CHECK(says(folder.gltf_refusal(triangle_json(R"({"mesh": 3})")), "no mesh 3"));
    CHECK(says(folder.gltf_refusal(triangle_json(R"({"mesh": 0, "scale": [1e300, 1e300, 1e300],
        "children": [1]}, {"scale": [1e300, 1, 1]})")),
               "not finite"));
    std::string deep;
    for (int i = 0; i < 2000; ++i)
        deep += R"({"children": [)" + std::to_string(i + 1) + "]}, ";
    CHECK(says(folder.gltf_refusal(triangle_json(deep + R"({"mesh": 0})")), "deeper than 1000"));

    // Numbers.
    CHECK(says(folder.gltf_refusal(changed(good, R"("POSITION": 0)", R"("POSITION": 9)")),
               "no accessor 9"));
    CHECK(says(folder.gltf_refusal(changed(good, R"("count": 3)", R"("count": 4)")), "beyond"));
    CHECK(folder.gltf_refusal(changed(good, R"("count": 3)", R"("count": 2147483648)")) !=
          "not refused");
    CHECK(folder.gltf_refusal(changed(good, R"("count": 3)", R"("count": 1e300)")) !=
          "not refused");
    CHECK(folder.gltf_refusal(changed(good, R"("count": 3)", R"("count": -1)")) != "not refused");
    CHECK(folder.gltf_refusal(changed(good, R"({"bufferView": 0,)", R"({"bufferView": 77,)")) !=
          "not refused");
    CHECK(says(folder.gltf_refusal(
                   changed(good, R"("byteOffset": 0)", R"("byteOffset": 18446744073709551615)")),
               "beyond"));
    CHECK(says(folder.gltf_refusal(changed(good, R"("byteLength": 60)", R"("byteLength": 61)")),
               "60 bytes of 61"));
    CHECK(says(folder.gltf_refusal(changed(good, "base64,", "base64,!")), "base64"));
    CHECK(folder.gltf_refusal(changed(good, "base64,", "")) != "not refused");
    CHECK(says(folder.gltf_refusal(triangle_json(R"({"mesh": 0})", R"(, "indices": 1)")),
               "does not hold indices"));
    CHECK(says(folder.gltf_refusal(triangle_json(R"({"mesh": 0})", R"(, "material": 4)")),
               "no material 4"));
    GltfBuffer bad;
    bad.add(bytes_of_list<float>({0, 0, std::nanf(""), 1, 0, 0, 0, 1, 0}));
    bad.add(bytes_of_list<uint32_t>({0, 1, 3}));
    const std::string nan = bad.json() + R"(, "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5125, "count": 3, "type": "SCALAR"}],
        "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}])";
    CHECK(says(folder.gltf_refusal(nan), "finite"));
    CHECK(says(
        folder.gltf_refusal(changed(nan, R"({"POSITION": 0})", R"({"POSITION": 0}, "indices": 1)")),
        "index 3"));

    // Containers and text.
    CHECK(folder.refusal("b.glb", "glTF") != "not refused");
    CHECK(folder.refusal("b.glb", glb("{}", "").substr(0, 22)) != "not refused");
    CHECK(folder.refusal("b.glb", glb("{}", "")) != "not refused");
    CHECK(folder.refusal("b.gltf", "") != "not refused");
    CHECK(says(folder.refusal("b.gltf", R"({"asset": {"version": "1.0"}})"), "glTF 1.0"));
    CHECK(folder.refusal("b.gltf", std::string(100000, '[')) != "not refused");
    CHECK(says(folder.gltf_refusal(good + R"(, "extensionsRequired": ["ACME_shape"])"),
               "ACME_shape"));
}

TEST_CASE("gltf: files beside the model are read, those outside its folder only if allowed") {
    const ModelFolder folder;
    std::filesystem::create_directory(folder.path / "inner");
    const std::string bytes = bytes_of_list<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
    folder.write("tri angle.bin", bytes);
    folder.write("inner/near.bin", bytes);
    const auto json = [](const std::string& uri) {
        return R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 36, "uri": ")" + uri +
               R"("}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
               "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3,
               "type": "VEC3"}], "nodes": [{"mesh": 0}],
               "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}]})";
    };
    CHECK(folder.read("a.gltf", json("tri%20angle.bin")).objects.size() == 1);
    CHECK(folder.read("a.gltf", json("inner/near.bin")).objects.size() == 1);
    CHECK(says(folder.refusal("inner/a.gltf", json("../tri%20angle.bin")), "outside"));
    CHECK(says(folder.refusal("inner/a.gltf", json("..\\\\tri%20angle.bin")), "outside"));
    CHECK(says(folder.refusal("a.gltf", json("/etc/passwd")), "outside"));
    CHECK(says(folder.refusal("a.gltf", json("https://example.org/a.bin")), "web address"));
    CHECK_THROWS_AS(folder.read("a.gltf", json("near.bin")), Error);
    ModelReadOptions options;
    options.allow_outside = true;
    CHECK(folder.read("inner/a.gltf", json("../tri%20angle.bin"), options).objects.size() == 1);
}

TEST_CASE("gltf: reading says how far it is, and stops when asked") {
    const ModelFolder folder;
    const std::string file =
        "{\"asset\": {\"version\": \"2.0\"}, " + triangle_json(R"({"mesh": 0})") + "}";
    double last = 0;
    ModelReadOptions options;
    options.progress = [&](double share) {
        CHECK(share >= last);
        last = share;
        return true;
    };
    folder.read("a.gltf", file, options);
    CHECK(last >= 0.5);
    options.progress = [](double) { return false; };
    CHECK_THROWS_AS(folder.read("a.gltf", file, options), Error);
}
