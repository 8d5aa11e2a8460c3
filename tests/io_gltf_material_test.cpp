// glTF: materials, their extensions and textures.
#include "io/gltf/gltf_read.h"
#include "support/gltf_files.h"
#include "support/shipped_scenes.h"

#include <teapath/io/image_file.h>

using namespace tp;
using namespace tp::test;

namespace {

// The bytes of a PNG of two pixels.
std::string png_bytes(const ModelFolder& folder) {
    Picture picture;
    picture.width = 2;
    picture.height = 1;
    picture.display = {255, 0, 0, 0, 0, 255};
    write_picture(folder.path / "made.png", picture);
    return text_of(folder.path / "made.png");
}

const Texture& texture_of(const ModelContent& content, TextureId id) {
    REQUIRE(id);
    REQUIRE(id.value <= content.textures.size());
    return content.textures[id.value - 1];
}

// One material of a triangle; `textures` textures show the images.
ModelContent material(const ModelFolder& folder, const std::string& json,
                      const std::string& rest = "") {
    return folder.gltf(triangle_json(R"({"mesh": 0})", R"(, "material": 0)",
                                     R"(, "materials": [)" + json + "]" + rest));
}

std::string with_images(const ModelFolder& folder) {
    return R"(, "images": [{"name": "wood", "mimeType": "image/png", "uri": "data:image/png;base64,)" +
           base64(png_bytes(folder)) +
           R"("}, {"uri": "made.png"}], "textures": [{"source": 0}, {"source": 1, "sampler": 0}],
           "samplers": [{"magFilter": 9728, "wrapS": 33071, "wrapT": 33648}])";
}

}  // namespace

TEST_CASE("gltf materials: factors, textures with their channels, samplers and transforms") {
    const ModelFolder folder;
    const ModelContent content = material(folder, R"({"name": "Table", "doubleSided": true,
        "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 0.75],
            "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform":
                {"offset": [0.5, 0.25], "scale": [2, 3], "rotation": 1.5707963267948966}}},
            "metallicFactor": 0.5, "roughnessFactor": 0.75,
            "metallicRoughnessTexture": {"index": 1, "texCoord": 1}},
        "normalTexture": {"index": 1, "scale": 0.5},
        "emissiveFactor": [1, 0.5, 0], "emissiveTexture": {"index": 0},
        "alphaMode": "MASK", "alphaCutoff": 0.25,
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4}}})",
                                          with_images(folder));
    REQUIRE(content.materials.size() == 1);
    const Material& m = content.materials[0];
    CHECK(m.name == "Table");
    CHECK(m.part.path == "Table");
    CHECK(m.kind == MaterialKind::Principled);
    CHECK(m.alpha == AlphaMode::Mask);
    CHECK(m.alpha_cutoff == 0.25);
    CHECK(m.opacity == 0.75);
    const Texture& base = texture_of(content, m.color.texture);
    CHECK(base.name == "wood");
    CHECK(base.file.path == "a.gltf#image/0");
    CHECK(base.tint == Double3(0.5, 0.25, 1));
    CHECK(base.color_space == ColorSpace::Srgb);
    CHECK(base.uv_offset == Double2(0.5, 0.25));
    CHECK(base.repeat == Double2(2, 3));
    CHECK(base.uv_rotation == doctest::Approx(90));
    REQUIRE(base.file.image);
    CHECK(base.file.image->width == 2);
    CHECK(m.surface.metallic.value == 0.5);
    CHECK(m.surface.metallic.channel == TextureChannel::Blue);
    CHECK(m.surface.roughness.value == 0.75);
    CHECK(m.surface.roughness.channel == TextureChannel::Green);
    CHECK(m.surface.roughness.texture == m.surface.metallic.texture);
    const Texture& rough = texture_of(content, m.surface.roughness.texture);
    CHECK(rough.uv_set == 1);
    CHECK(rough.color_space == ColorSpace::Linear);
    CHECK(rough.wrap == WrapMode::Clamp);
    CHECK(rough.wrap_v == WrapModeV::Mirror);
    CHECK(rough.filter == FilterMode::Nearest);
    CHECK(rough.file.path == "made.png");
    CHECK(rough.name == "made");
    REQUIRE(rough.file.image);
    const Texture& normal = texture_of(content, m.surface.normal);
    CHECK(normal.part.path == "made 2");
    CHECK(normal.file.image == rough.file.image);  // decoded once
    CHECK(m.surface.normal_scale == 0.5);
    CHECK(m.emits);
    CHECK(m.strength == 4);
    CHECK(m.side == EmissionSide::Both);
    CHECK(texture_of(content, m.emission.texture).tint == Double3(1, 0.5, 0));
    CHECK(content.unsupported.empty());
}

TEST_CASE("gltf materials: the extensions of the surface") {
    const ModelFolder folder;
    const ModelContent content = material(folder, R"({"alphaMode": "BLEND", "extensions": {
        "KHR_materials_ior": {"ior": 1.33},
        "KHR_materials_transmission": {"transmissionFactor": 0.9},
        "KHR_materials_volume": {"thicknessFactor": 1, "attenuationDistance": 2,
            "attenuationColor": [1, 0.5, 0.25]},
        "KHR_materials_dispersion": {"dispersion": 0.3},
        "KHR_materials_clearcoat": {"clearcoatFactor": 0.5, "clearcoatRoughnessFactor": 0.1,
            "clearcoatNormalTexture": {"index": 0, "scale": 2}},
        "KHR_materials_sheen": {"sheenColorFactor": [0.1, 0.2, 0.3], "sheenRoughnessFactor": 0.4},
        "KHR_materials_specular": {"specularFactor": 0.6, "specularColorFactor": [1, 2, 3]},
        "KHR_materials_anisotropy": {"anisotropyStrength": 0.7, "anisotropyRotation": 1.5707963},
        "KHR_materials_iridescence": {"iridescenceFactor": 0.8, "iridescenceIor": 1.4,
            "iridescenceThicknessMaximum": 500},
        "KHR_materials_diffuse_transmission": {"diffuseTransmissionFactor": 0.25}}})",
                                          with_images(folder));
    const Material& m = content.materials.at(0);
    const PrincipledSurface& s = m.surface;
    CHECK(m.alpha == AlphaMode::Blend);
    CHECK(m.ior == 1.33);
    CHECK(s.transmission.value == 0.9);
    CHECK_FALSE(s.thin);
    CHECK(s.attenuation_distance == 2);
    CHECK(s.attenuation_color == Double3(1, 0.5, 0.25));
    CHECK(s.dispersion == 0.3);
    CHECK(s.coat.value == 0.5);
    CHECK(s.coat_roughness.value == 0.1);
    CHECK(texture_of(content, s.coat_normal).color_space == ColorSpace::Linear);
    CHECK(s.coat_normal_scale == 2);
    CHECK(s.sheen_color.color == Double3(0.1, 0.2, 0.3));
    CHECK(s.sheen_roughness.value == 0.4);
    CHECK(s.specular.value == 0.6);
    CHECK(s.specular_color.color == Double3(1, 2, 3));
    CHECK(s.anisotropy.value == 0.7);
    CHECK(s.anisotropy_rotation == doctest::Approx(90));
    CHECK(s.iridescence.value == 0.8);
    CHECK(s.iridescence_ior == 1.4);
    CHECK(s.iridescence_thickness.value == 500);
    CHECK(s.diffuse_transmission.value == 0.25);
    CHECK(content.unsupported.empty());
}

TEST_CASE("gltf materials: specular and glossiness keep the reflection, unlit ones emit") {
    const ModelFolder folder;
    const ModelContent content = material(folder, R"({"extensions":
        {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.5, 0.5, 0.5, 1],
         "specularFactor": [0.2, 0.4, 0.8], "glossinessFactor": 0.5,
         "specularGlossinessTexture": {"index": 0}}}},
        {"name": "Sign", "pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0.25, 1]},
         "extensions": {"KHR_materials_unlit": {}}})",
                                          with_images(folder));
    const Material& gloss = content.materials.at(0);
    CHECK(gloss.color.color == Double3(0.5));
    CHECK(gloss.surface.metallic.value == 0);
    const Double3 tint = texture_of(content, gloss.surface.specular_color.texture).tint;
    CHECK(tint.y == doctest::Approx(10));  // 0.4 = 0.04 * 10
    const Texture& rough = texture_of(content, gloss.surface.roughness.texture);
    REQUIRE(rough.file.image);
    CHECK(rough.file.image->bytes[0] == std::byte{128});  // no alpha: gloss is the factor
    CHECK(gloss.surface.roughness.value == 1);
    const Material& sign = content.materials.at(1);
    CHECK(sign.emits);
    CHECK(sign.emission.color == Double3(1, 0.5, 0.25));
    CHECK(sign.color.color == Double3(0));
    CHECK(sign.surface.specular.value == 0);
    REQUIRE(content.unsupported.size() == 1);
    CHECK(says(content.unsupported[0], "Sign"));
}

TEST_CASE("gltf materials: a missing or damaged image is a sentence, not a refusal") {
    const ModelFolder folder;
    folder.write("bad.png", "not a picture");
    const ModelContent content =
        material(folder, R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0},
                   "metallicRoughnessTexture": {"index": 1}}, "normalTexture": {"index": 2}})",
                 R"(, "images": [{"uri": "none.png"}, {"uri": "bad.png"}],
            "textures": [{"source": 0}, {"source": 1}, {}])");
    CHECK(content.textures.size() == 3);
    for (const Texture& texture : content.textures)
        CHECK_FALSE(texture.file.image);
    CHECK(content.unsupported.size() == 3);
    CHECK(says(
        folder.gltf_refusal(triangle_json(R"({"mesh": 0})", R"(, "material": 0)",
                                          R"(, "materials": [{"normalTexture": {"index": 8}}])")),
        "no texture 8"));
}

TEST_CASE("gltf materials: an image larger than the memory at hand is a sentence") {
    const ModelFolder folder;
    std::string png = png_bytes(folder);
    png[18] = png[22] = 0x20;  // 8194 x 8193 pixels, says the header
    CHECK(bytes_of_image(png) == uint64_t{8194} * 8193 * 3);
    ModelSource source;
    source.name = "a.gltf";
    source.memory = uint64_t{64} << 20;
    const ModelContent content =
        read_gltf("{\"asset\": {\"version\": \"2.0\"}, " +
                      triangle_json(R"({"mesh": 0})", R"(, "material": 0)",
                                    R"(, "materials": [{"normalTexture": {"index": 0}}],
                          "textures": [{"source": 0}], "images": [{"uri": "data:;base64,)" +
                                        base64(png) + "\"}]") +
                      "}",
                  source);
    CHECK_FALSE(content.textures.at(0).file.image);
    REQUIRE(content.unsupported.size() == 1);
    CHECK(says(content.unsupported[0], "192 MiB"));
}
