// OBJ, PLY and STL as models: objects, and materials from MTL libraries.
#include "support/gltf_files.h"
#include "support/shipped_scenes.h"

#include <teapath/io/image_file.h>

#include <cmath>

using namespace tp;
using namespace tp::test;

namespace {

const std::string kSquares =
    "mtllib my library.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "o Table\nusemtl wood\nf 1/1 2/2 3/3 4/4\nusemtl glass\nf 1 2 3\no Lamp\nusemtl light\n"
    "f 1 3 4\nusemtl unknown\nf 2 3 4\n";

void write_png(const std::filesystem::path& file, std::vector<uint8_t> display) {
    Picture picture;
    picture.width = 2;
    picture.height = 1;
    picture.display = std::move(display);
    write_picture(file, picture);
}

const Material& named(const ModelContent& content, const char* name) {
    for (const Material& m : content.materials)
        if (m.name == name) return m;
    FAIL("no such material");
    return content.materials[0];
}

}  // namespace

TEST_CASE("obj models: one object for each group and material, with the library's materials") {
    const ModelFolder folder;
    std::filesystem::create_directory(folder.path / "maps");
    write_png(folder.path / "maps/wood.png", {255, 0, 0, 0, 255, 0});
    write_png(folder.path / "holes.png", {255, 255, 255, 0, 0, 0});
    write_png(folder.path / "n.png", {128, 128, 255, 100, 128, 250});
    folder.write("my library.mtl",
                 "newmtl wood\nKd 0 0 0\nmap_Kd -s 2 3 1 -o 0.5 0.25 0 maps\\wood.png\n"
                 "map_d holes.png\nKs 0.5 0.25 0\nNs 6\nnorm n.png\nmap_Bump none.png\n"
                 "newmtl glass\nKd 1 1 1\nNi 1.33\nd 0.25\nillum 7\nTf 0.5 0.75 1\n"
                 "newmtl light\nKd 0.5 0.5 0.5\nKe 1 2 3\nd 0.5\nPr 0.75\nPm 1\nPc 0.5\nPcr 0.25\n"
                 "aniso 0.5\nanisor 0.25\nPs 0.5\n");
    const ModelContent content = folder.read("a.obj", kSquares);
    REQUIRE(content.objects.size() == 4);
    CHECK(content.objects[0].part.path == "Table.1");
    CHECK(content.objects[1].part.path == "Table.2");
    CHECK(content.objects[2].part.path == "Lamp.1");
    CHECK(mesh_of(content.objects[0]).triangles.size() == 2);
    CHECK(mesh_of(content.objects[1]).positions.size() == 3);
    CHECK(content.objects[3].material == named(content, "unknown").id);

    const Material& wood = named(content, "wood");
    CHECK(content.objects[0].material == wood.id);
    CHECK(wood.kind == MaterialKind::Principled);
    CHECK(wood.alpha == AlphaMode::Blend);
    REQUIRE(wood.color.texture);
    const Texture& planks = content.textures.at(wood.color.texture.value - 1);
    CHECK(planks.tint == Double3(1));
    CHECK(planks.name == "wood");
    CHECK(planks.repeat == Double2(2, 3));
    CHECK(planks.uv_offset == Double2(0.5, -2.25));
    REQUIRE(planks.file.image);
    REQUIRE(planks.file.image->channels == 4);
    CHECK(planks.file.image->bytes[0] == std::byte{255});
    CHECK(planks.file.image->bytes[3] == std::byte{255});
    CHECK(planks.file.image->bytes[7] == std::byte{0});  // a hole
    CHECK(wood.surface.specular.value == 1);
    CHECK(wood.surface.specular_color.color == Double3(1, 0.5, 0));
    CHECK(wood.surface.roughness.value == doctest::Approx(std::sqrt(0.5)));  // alpha = 1/2
    CHECK(content.textures.at(wood.surface.normal.value - 1).name == "n");

    const Material& glass = named(content, "glass");
    CHECK(glass.surface.transmission.value == 0.75);
    CHECK_FALSE(glass.surface.thin);
    CHECK(glass.ior == doctest::Approx(1.33));
    CHECK(glass.color.color == Double3(0.5, 0.75, 1));
    CHECK(glass.opacity == 1);

    const Material& light = named(content, "light");
    CHECK(light.emits);
    CHECK(light.emission.color == Double3(1, 2, 3));
    CHECK(light.opacity == 0.5);
    CHECK(light.surface.roughness.value == 0.75);
    CHECK(light.surface.metallic.value == 1);
    CHECK(light.surface.coat.value == 0.5);
    CHECK(light.surface.coat_roughness.value == 0.25);
    CHECK(light.surface.anisotropy.value == 0.5);
    CHECK(light.surface.anisotropy_rotation == 90);
    REQUIRE(content.unsupported.size() == 1);
    CHECK(says(content.unsupported[0], "unknown"));
}

TEST_CASE("obj models: without library, images or with heights they load all the same") {
    const ModelFolder folder;
    const ModelContent bare = folder.read("a.obj", kSquares);
    CHECK(bare.objects.size() == 4);
    CHECK(bare.unsupported.size() == 6);  // "my", "library.mtl", and four materials
    write_png(folder.path / "heights.png", {10, 10, 10, 200, 200, 200});
    folder.write("my library.mtl",
                 "newmtl wood\nmap_Kd none.png\nmap_Bump heights.png\nnewmtl glass\n"
                 "map_Kd /etc/none.png\nnewmtl light\nnewmtl unknown\n");
    const ModelContent content = folder.read("a.obj", kSquares);
    CHECK_FALSE(named(content, "wood").surface.normal);
    CHECK(content.unsupported.size() == 3);
    CHECK(folder.read("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").objects.at(0).name == "b");
    CHECK(says(folder.refusal("c.obj", "v 0 0 0\nf 1 2 3\n"), "index 2"));
    CHECK(says(folder.refusal("d.obj", "v 0 0 0\n"), "no triangles"));
}

TEST_CASE("ply and stl models: one object of a material of its own") {
    const ModelFolder folder;
    const ModelContent ply = folder.read(
        "cube.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 "
        "0\n0 1 0\n3 0 1 2\n");
    REQUIRE(ply.objects.size() == 1);
    CHECK(ply.objects[0].part.path == "cube");
    CHECK(ply.objects[0].material == ply.materials.at(0).id);
    CHECK(ply.materials[0].kind == MaterialKind::Principled);
    CHECK(folder.refusal("a.stl", "") != "not refused");
    CHECK(folder.refusal("a.fbx", "") != "not refused");
    CHECK(can_read_model("A.GLB"));
    CHECK_FALSE(can_read_model("a.fbx"));
}
