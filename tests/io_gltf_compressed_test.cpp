// glTF: compressed and quantised geometry, WebP, instances, morph targets and skins.
#include "support/gltf_files.h"

#include <teapath/io/image_file.h>

#include <doctest/doctest.h>
#include <draco/compression/encode.h>
#include <draco/core/encoder_buffer.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>
#include <webp/encode.h>

#include <cstdlib>

using namespace tp;
using namespace tp::test;

namespace {

const std::vector<float> kSquare = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const std::vector<uint32_t> kCorners = {0, 1, 2, 0, 2, 3};

std::string text_of_bytes(const std::vector<unsigned char>& bytes, size_t size) {
    return {reinterpret_cast<const char*>(bytes.data()), size};
}

// A file with the square in two views that meshopt compressed.
std::string meshopt_json(const std::string& change = "") {
    std::vector<unsigned char> vertices(meshopt_encodeVertexBufferBound(4, 12));
    vertices.resize(
        meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), kSquare.data(), 4, 12));
    std::vector<unsigned char> indices(meshopt_encodeIndexBufferBound(6, 4));
    indices.resize(meshopt_encodeIndexBuffer(indices.data(), indices.size(), kCorners.data(), 6));
    std::string bytes = text_of_bytes(vertices, vertices.size());
    const size_t start = bytes.size();
    bytes += text_of_bytes(indices, indices.size());
    if (!change.empty()) bytes = change;
    return R"("extensionsRequired": ["EXT_meshopt_compression"], "buffers": [{"byteLength": )" +
           std::to_string(bytes.size()) + R"(, "uri": "data:;base64,)" + base64(bytes) +
           R"("}, {"byteLength": 72, "extensions": {"EXT_meshopt_compression":
              {"fallback": true}}}], "bufferViews": [
              {"buffer": 1, "byteLength": 48, "byteStride": 12, "extensions":
               {"EXT_meshopt_compression": {"buffer": 0, "byteLength": )" +
           std::to_string(start) + R"(, "byteStride": 12, "count": 4, "mode": "ATTRIBUTES"}}},
              {"buffer": 1, "byteOffset": 48, "byteLength": 24, "extensions":
               {"EXT_meshopt_compression": {"buffer": 0, "byteOffset": )" +
           std::to_string(start) + R"(, "byteLength": )" + std::to_string(bytes.size() - start) +
           R"(, "byteStride": 4, "count": 6, "mode": "TRIANGLES"}}}],
              "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
              {"bufferView": 1, "componentType": 5125, "count": 6, "type": "SCALAR"}],
              "nodes": [{"mesh": 0}],
              "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}])";
}

std::string draco_bytes(int& position_id) {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(2);
    position_id = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    for (uint32_t f = 0; f < 2; ++f)
        builder.SetAttributeValuesForFace(
            position_id, draco::FaceIndex(f), &kSquare[3 * kCorners[3 * f]],
            &kSquare[3 * kCorners[3 * f + 1]], &kSquare[3 * kCorners[3 * f + 2]]);
    const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
    position_id = static_cast<int>(mesh->attribute(position_id)->unique_id());
    draco::Encoder encoder;
    draco::EncoderBuffer buffer;
    REQUIRE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    return {buffer.data(), buffer.size()};
}

float area_of(const Mesh& mesh) {
    float area = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        area +=
            glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a])
                .z /
            2;
    return area;
}

}  // namespace

TEST_CASE("gltf: EXT_meshopt_compression, whole and damaged") {
    const ModelFolder folder;
    const ModelContent content = folder.gltf(meshopt_json());
    REQUIRE(content.objects.size() == 1);
    CHECK(mesh_of(content.objects[0]).positions[2] == Float3(1, 1, 0));
    CHECK(area_of(mesh_of(content.objects[0])) == doctest::Approx(1));
    CHECK(folder.gltf_refusal(meshopt_json(std::string(100, 'x'))) != "not refused");
    const auto changed = [](const std::string& from, const std::string& to) {
        std::string json = meshopt_json();
        REQUIRE(json.find(from) != std::string::npos);
        return json.replace(json.find(from), from.size(), to);
    };
    CHECK(says(folder.gltf_refusal(
                   changed(R"("byteStride": 12, "count")", R"("byteStride": 13, "count")")),
               "as it should be"));
    CHECK(folder.gltf_refusal(changed(R"("count": 4, "mode")", R"("count": 2000000000, "mode")")) !=
          "not refused");
}

TEST_CASE("gltf: KHR_draco_mesh_compression, whole and damaged") {
    const ModelFolder folder;
    int id = 0;
    const std::string bytes = draco_bytes(id);
    const auto json = [&](const std::string& data) {
        GltfBuffer buffer;
        buffer.add(data);
        return buffer.json() + R"(, "extensionsRequired": ["KHR_draco_mesh_compression"],
            "accessors": [{"componentType": 5126, "count": 4, "type": "VEC3"},
            {"componentType": 5125, "count": 6, "type": "SCALAR"}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1,
            "extensions": {"KHR_draco_mesh_compression": {"bufferView": 0, "attributes":
            {"POSITION": )" +
               std::to_string(id) + "}}}}]}]";
    };
    const ModelContent content = folder.gltf(json(bytes));
    REQUIRE(content.objects.size() == 1);
    CHECK(mesh_of(content.objects[0]).positions.size() == 4);
    CHECK(area_of(mesh_of(content.objects[0])) == doctest::Approx(1));
    CHECK(says(folder.gltf_refusal(json(bytes.substr(0, bytes.size() / 2))), "damaged"));
    CHECK(folder.gltf_refusal(json("DRACO")) != "not refused");
}

TEST_CASE("gltf: KHR_mesh_quantization and its node that scales back") {
    const ModelFolder folder;
    GltfBuffer buffer;
    buffer.add(bytes_of_list<uint16_t>({0, 0, 0, 0, 1000, 0, 0, 0, 0, 500, 0, 0}), 8);
    buffer.add(bytes_of_list<int8_t>({0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0}), 4);
    buffer.add(bytes_of_list<uint8_t>({0, 255, 0, 0, 255, 255, 0, 0, 0, 0, 0, 0}), 4);
    const ModelContent content = folder.gltf(buffer.json() + R"(,
        "extensionsRequired": ["KHR_mesh_quantization"], "accessors": [
        {"bufferView": 0, "componentType": 5123, "count": 3, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5120, "normalized": true, "count": 3, "type": "VEC3"},
        {"bufferView": 2, "componentType": 5121, "normalized": true, "count": 3, "type": "VEC2"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1,
            "TEXCOORD_0": 2}}]}], "nodes": [{"mesh": 0, "scale": [0.002, 0.002, 0.002]}])");
    REQUIRE(content.objects.size() == 1);
    const Mesh& mesh = mesh_of(content.objects[0]);
    CHECK(mesh.positions[1] == Float3(1000, 0, 0));
    CHECK(mesh.normals[0] == Float3(0, 0, 1));
    CHECK(mesh.uvs.at(0)[1] == Float2(1, 1));
    CHECK(content.objects[0].transform.scale.x == 0.002);
}

TEST_CASE("gltf: EXT_texture_webp") {
    const ModelFolder folder;
    const uint8_t pixels[6] = {255, 0, 0, 0, 0, 255};
    uint8_t* encoded = nullptr;
    const size_t size = WebPEncodeLosslessRGB(pixels, 2, 1, 6, &encoded);
    REQUIRE(size > 0);
    const std::string bytes(reinterpret_cast<const char*>(encoded), size);
    WebPFree(encoded);
    folder.write("a.webp", bytes);
    const std::string json = triangle_json(R"({"mesh": 0})", R"(, "material": 0)",
                                           R"(, "images": [{"uri": "none.png"}, {"uri": "a.webp"}],
             "textures": [{"source": 0, "extensions": {"EXT_texture_webp": {"source": 1}}}],
             "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}])");
    const ModelContent content = folder.gltf(json);
    REQUIRE(content.textures.size() == 1);
    REQUIRE(content.textures[0].file.image);
    CHECK(content.textures[0].file.image->channels == 3);
    CHECK(content.textures[0].file.image->bytes[5] == std::byte{255});
    CHECK(content.unsupported.empty());
    CHECK_THROWS_AS(read_image_from_memory(bytes.substr(0, bytes.size() - 4), "a"), Error);
}

TEST_CASE("gltf: EXT_mesh_gpu_instancing makes an object for each instance") {
    const ModelFolder folder;
    GltfBuffer buffer;
    buffer.add(bytes_of_list<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    buffer.add(bytes_of_list<float>({1, 0, 0, 2, 0, 0}));
    const auto json = [&](const char* count) {
        return buffer.json() + R"(, "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5126, "count": )" +
               count + R"(, "type": "VEC3"}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "nodes": [{"mesh": 0, "name": "Tree", "translation": [0, 5, 0], "extensions":
            {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 1, "SCALE": 1}}}}])";
    };
    CHECK(folder.gltf(json("0")).objects.empty());
    const ModelContent content = folder.gltf(json("2"));
    CHECK(content.objects.empty());  // a scale of (1, 0, 0) leaves no volume
    std::string moved = json("2");
    moved.replace(moved.find(", \"SCALE\": 1"), 12, "");
    const ModelContent trees = folder.gltf(moved);
    REQUIRE(trees.objects.size() == 2);
    CHECK(trees.objects[1].part.path == "Tree:2");
    CHECK(trees.objects[1].transform.translation == Double3(2, 5, 0));
    CHECK(&mesh_of(trees.objects[0]) == &mesh_of(trees.objects[1]));
}

TEST_CASE("gltf: morph targets by their weights, skins by their joints") {
    const ModelFolder folder;
    GltfBuffer buffer;
    buffer.add(bytes_of_list<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    buffer.add(bytes_of_list<float>({0, 0, 2, 0, 0, 2, 0, 0, 2}));
    buffer.add(bytes_of_list<uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}));
    buffer.add(bytes_of_list<float>({1, 0, 0, 0, 0, 1, 0, 0, 0.5f, 0.5f, 0, 0}));
    const std::string json = buffer.json() + R"(, "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"},
        {"bufferView": 2, "componentType": 5121, "count": 3, "type": "VEC4"},
        {"bufferView": 3, "componentType": 5126, "count": 3, "type": "VEC4"}],
        "meshes": [{"weights": [0.5], "primitives": [{"attributes": {"POSITION": 0},
            "targets": [{"POSITION": 1}]}]},
            {"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 2, "WEIGHTS_0": 3}}]}],
        "skins": [{"joints": [2, 3]}],
        "nodes": [{"mesh": 0}, {"mesh": 0, "weights": [1]}, {}, {"translation": [0, 0, 10]},
            {"mesh": 1, "skin": 0, "translation": [9, 9, 9]}])";
    const ModelContent content = folder.gltf(json);
    REQUIRE(content.objects.size() == 3);
    CHECK(mesh_of(content.objects[0]).positions[1] == Float3(1, 0, 1));
    CHECK(mesh_of(content.objects[1]).positions[1] == Float3(1, 0, 2));
    const Mesh& skinned = mesh_of(content.objects[2]);
    CHECK(skinned.positions[0] == Float3(0, 0, 0));
    CHECK(skinned.positions[1] == Float3(1, 0, 10));
    CHECK(skinned.positions[2] == Float3(0, 1, 5));
    CHECK(content.objects[2].transform == Transform{});  // the joints say where it is
    std::string beyond = json;
    beyond.replace(beyond.find("\"joints\": [2, 3]"), 16, "\"joints\": [2]");
    CHECK(says(folder.gltf_refusal(beyond), "joint 1"));
}
