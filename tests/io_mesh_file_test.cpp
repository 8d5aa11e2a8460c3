// Mesh files: every format gives the same triangles, and a bad file is refused with a sentence.
#include "support/temporary_folder.h"

#include <teapath/core/error.h>
#include <teapath/io/mesh_file.h>
#include <teapath/io/scene_file.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <vector>

using namespace tp;

namespace {

struct MeshFolder : test::TemporaryFolder {
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path / name, std::ios::binary) << bytes;
        return path / name;
    }
    Mesh read(const std::string& name, const std::string& bytes) const {
        return read_mesh(write(name, bytes));
    }
    // What the refusal of such a file says.
    std::string refusal(const std::string& name, const std::string& bytes) const {
        try {
            read(name, bytes);
        } catch (const Error& error) {
            CHECK(error.kind() == ErrorKind::Input);
            CHECK(error.where().find(name) != std::string::npos);
            return error.what();
        }
        return "not refused";
    }
};

template <class T>
void append(std::string& bytes, T value, bool big_endian = false) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (big_endian) std::reverse(raw, raw + sizeof raw);
    bytes.append(raw, sizeof raw);
}

const std::string kAsciiPly =
    "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty float x\nproperty float "
    "y\n"
    "property float z\nproperty float s\nproperty float t\nproperty uchar red\nproperty uchar "
    "green\n"
    "property uchar blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 0 0 255 0 0\n1 0 0 1 0 255 255 255\n1 1 0 1 1 0 0 0\n0 1 0 0 1 0 0 255\n4 0 1 2 3\n";

// The same square, binary.
std::string binary_ply(bool big_endian) {
    std::string bytes = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                        "_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                        "property double z\nelement face 1\nproperty list uchar uint "
                        "vertex_indices\nend_header\n";
    const float corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const auto& corner : corners) {
        append(bytes, corner[0], big_endian);
        append(bytes, corner[1], big_endian);
        append(bytes, 0.0, big_endian);
    }
    append(bytes, uint8_t{4});
    for (uint32_t i = 0; i < 4; ++i)
        append(bytes, i, big_endian);
    return bytes;
}

std::string binary_stl(uint32_t count_said, uint32_t count) {
    std::string bytes = "solid but binary";
    bytes.resize(80, ' ');
    append(bytes, count_said);
    const float corners[2][9] = {{0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 0, 0, 1, 1, 0, 0, 1, 0}};
    for (uint32_t t = 0; t < count; ++t) {
        bytes.append(12, '\0');
        for (const float x : corners[t % 2])
            append(bytes, x);
        bytes.append(2, '\0');
    }
    return bytes;
}

void check_square(const Mesh& mesh) {
    CHECK(mesh.positions.size() == 4);
    CHECK(mesh.triangles.size() == 2);
    CHECK(problem_of(mesh) == "");
    float area = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        area +=
            glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a])
                .z /
            2;
    CHECK(area == doctest::Approx(1));  // and all fronts to +z
}

}  // namespace

TEST_CASE("mesh files: PLY, STL and OBJ, as text and binary, hold the same square") {
    const MeshFolder folder;
    const Mesh ply = folder.read("a.ply", kAsciiPly);
    check_square(ply);
    REQUIRE(ply.uvs.size() == 1);
    CHECK(ply.uvs[0][0] == Float2(0, 1));  // v = 0 is on top
    REQUIRE(ply.colors.size() == 4);
    CHECK(ply.colors[0] == Float4(1, 0, 0, 1));
    check_square(folder.read("b.PLY", binary_ply(false)));
    check_square(folder.read("c.ply", binary_ply(true)));
    check_square(folder.read("d.stl", binary_stl(2, 2)));
    check_square(folder.read(
        "e.stl",
        "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
        "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 "
        "0\nendloop\nendfacet\nendsolid s\n"));
    const Mesh obj =
        folder.read("f.obj",
                    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
                    "f 1/1/1 2/2/1 3/3/1 -1/-1/1\n");
    check_square(obj);
    REQUIRE(obj.uvs.size() == 1);
    CHECK(obj.uvs[0][0] == Float2(0, 1));
    REQUIRE(obj.normals.size() == 4);
    CHECK(obj.normals[0] == Float3(0, 0, 1));
}

TEST_CASE("mesh files: a concave face is cut inside its outline") {
    const MeshFolder folder;
    // An arrow head: the corner at (1, 1) points inwards.
    const Mesh mesh = folder.read("a.obj", "v 0 0 0\nv 1 1 0\nv 2 0 0\nv 1 3 0\nf 1 2 3 4\n");
    float area = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        area += std::abs(glm::cross(mesh.positions[b] - mesh.positions[a],
                                    mesh.positions[c] - mesh.positions[a])
                             .z) /
                2;
    CHECK(area == doctest::Approx(2));
}

TEST_CASE("mesh files: what lies, ends early or is no mesh is refused with a sentence") {
    const MeshFolder folder;
    CHECK(folder.refusal("a.ply", "plx\n").find("not a PLY") != std::string::npos);
    CHECK(folder.refusal("b.ply", kAsciiPly.substr(0, kAsciiPly.size() - 12)) != "not refused");
    std::string beyond = kAsciiPly;
    beyond.replace(beyond.rfind("2 3"), 3, "2 9");
    CHECK(folder.refusal("c.ply", beyond).find("index 9") != std::string::npos);
    std::string huge = kAsciiPly;
    huge.replace(huge.find("vertex 4"), 8, "vertex 2147483648");
    CHECK(folder.refusal("d.ply", huge) != "not refused");
    std::string many = binary_ply(false);
    many.replace(many.find("vertex 4"), 8, "vertex 2000000000");
    CHECK(folder.refusal("e.ply", many) != "not refused");
    std::string nan = kAsciiPly;
    nan.replace(nan.find("1 1 0 1 1"), 9, "nan 1 0 1 1");
    CHECK(folder.refusal("f.ply", nan) != "not refused");
    CHECK(folder.refusal("g.stl", binary_stl(2000000000, 2)) != "not refused");
    CHECK(folder.refusal("h.stl", "") != "not refused");
    CHECK(folder.refusal("i.obj", "v 0 0 0\nf 1 2 3\n") != "not refused");
    CHECK(folder.refusal("j.obj", "# nothing\n").find("no triangles") != std::string::npos);
    CHECK(folder.refusal("k.xyz", "v") != "not refused");
    CHECK_THROWS_AS(read_mesh(folder.path / "none.ply"), Error);
}

TEST_CASE("mesh files: a scene reads each file once, keeps its path, and goes on without it") {
    const MeshFolder folder;
    folder.write("square.ply", kAsciiPly);
    const std::string text = R"({"teapath": 1, "objects": [
        {"shape": {"type": "mesh", "file": "square.ply"}},
        {"shape": {"type": "mesh", "file": "square.ply", "smooth": false,
                   "placement": [1, 0, 0, 0.5, 1, 0, 0, 0, 1]}},
        {"shape": {"type": "mesh", "file": "none.ply"}}]})";
    const Scene scene = parse_scene(text, folder.path, "test.json");
    REQUIRE(scene.objects.size() == 3);
    const auto shape = [&](size_t i) { return std::get<MeshShape>(scene.objects[i].shape); };
    REQUIRE(shape(0).file.mesh);
    CHECK(shape(0).file.mesh == shape(1).file.mesh);
    CHECK(shape(0).file.mesh->high == Float3(1, 1, 0));
    CHECK(shape(1).placement[1] == Double3(0.5, 1, 0));
    CHECK_FALSE(shape(2).file.mesh);
    CHECK(parse_scene(scene_text(scene), folder.path, "again.json") == scene);
    // Saved elsewhere, the path leads back.
    const MeshFolder other;
    save_scene(scene, other.path / "scene.json");
    CHECK(std::get<MeshShape>(load_scene(other.path / "scene.json").objects[0].shape).file.mesh);
}
