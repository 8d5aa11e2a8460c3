#include "gltf_materials.h"

#include "gltf_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;
constexpr double kUsualIor = 1.5, kUsualF0 = 0.04;

double share(double x) {
    return std::clamp(x, 0.0, 1.0);
}
Double3 not_negative(Double3 c) {
    return glm::max(c, Double3(0));
}

class MaterialReader {
public:
    MaterialReader(const tinygltf::Material& source, std::string name, std::string where,
                   GltfTextures& textures, ModelContent& content)
        : source_(source), where_(std::move(where)), textures_(textures), content_(content) {
        m_.name = m_.part.path = std::move(name);
    }

    Material read() {
        m_.kind = MaterialKind::Principled;
        read_alpha();
        if (const auto* e = extension("KHR_materials_pbrSpecularGlossiness"))
            read_specular_glossiness(*e);
        else
            read_metallic_roughness();
        read_normal();
        read_emission();
        if (const auto* e = extension("KHR_materials_ior")) read_ior(*e);
        if (const auto* e = extension("KHR_materials_specular")) read_specular(*e);
        read_transmission();
        if (const auto* e = extension("KHR_materials_clearcoat")) read_coat(*e);
        if (const auto* e = extension("KHR_materials_sheen")) read_sheen(*e);
        if (const auto* e = extension("KHR_materials_anisotropy")) read_anisotropy(*e);
        if (const auto* e = extension("KHR_materials_iridescence")) read_iridescence(*e);
        if (extension("KHR_materials_unlit")) make_unlit();
        return std::move(m_);
    }

private:
    const tinygltf::Value* extension(const char* name) const {
        return find_extension(source_.extensions, name);
    }

    TextureId linear(const TextureUse& use) {
        return textures_.add(use, ColorSpace::Linear, where_);
    }

    // The factor where there is no texture, else a texture tinted by it.
    TexturedColor color(Double3 factor, const TextureUse& use) {
        factor = not_negative(factor);
        return {factor, textures_.add(use, ColorSpace::Srgb, where_, factor)};
    }

    TexturedNumber number(double value, const TextureUse& use, TextureChannel channel) {
        return {value, linear(use), channel};
    }
    TexturedNumber number_of(const tinygltf::Value& e, const char* factor, double absent,
                             const char* texture, TextureChannel channel) {
        return number(share(number_in(e, factor, absent)), use_in(e, texture), channel);
    }

    void read_metallic_roughness() {
        const auto& pbr = source_.pbrMetallicRoughness;
        const auto factor = vector_of(pbr.baseColorFactor, Double4(1));
        base_ = use_of(pbr.baseColorTexture);
        base_factor_ = Double3(factor);
        m_.color = color(base_factor_, base_);
        if (m_.alpha != AlphaMode::Opaque) m_.opacity = share(factor.w);
        const TextureUse both = use_of(pbr.metallicRoughnessTexture);
        m_.surface.metallic = number(share(pbr.metallicFactor), both, TextureChannel::Blue);
        m_.surface.roughness = number(share(pbr.roughnessFactor), both, TextureChannel::Green);
    }

    void read_alpha() {
        m_.alpha = source_.alphaMode == "BLEND"  ? AlphaMode::Blend
                   : source_.alphaMode == "MASK" ? AlphaMode::Mask
                                                 : AlphaMode::Opaque;
        m_.alpha_cutoff = std::max(source_.alphaCutoff, 0.0);
        if (source_.doubleSided) m_.side = EmissionSide::Both;
    }

    void read_normal() {
        const TextureUse use = use_of(source_.normalTexture);
        m_.surface.normal = linear(use);
        m_.surface.normal_scale = use.scale;
    }

    void read_emission() {
        const Double3 factor = not_negative(vector_of(source_.emissiveFactor, Double3(0)));
        if (factor == Double3(0)) return;
        m_.emits = true;
        m_.emission = color(factor, use_of(source_.emissiveTexture));
        if (const auto* e = extension("KHR_materials_emissive_strength"))
            m_.strength = std::max(number_in(*e, "emissiveStrength", 1), 0.0);
    }

    // The diffuse colour stays, the specular colour becomes that of a dielectric's reflection at
    // normal incidence: specular = f0(1.5) * specular_color. Nothing is metallic then.
    void read_specular_glossiness(const tinygltf::Value& e) {
        const auto diffuse = vector_in(e, "diffuseFactor", Double4(1));
        base_ = use_in(e, "diffuseTexture");
        base_factor_ = Double3(diffuse);
        m_.color = color(base_factor_, base_);
        if (m_.alpha != AlphaMode::Opaque) m_.opacity = share(diffuse.w);
        m_.ior = kUsualIor;
        m_.surface.metallic = {0, {}, TextureChannel::Blue};
        const TextureUse gloss = use_in(e, "specularGlossinessTexture");
        m_.surface.specular_color =
            color(vector_in(e, "specularFactor", Double3(1)) / kUsualF0, gloss);
        const double glossiness = share(number_in(e, "glossinessFactor", 1));
        m_.surface.roughness = {1 - glossiness, {}, TextureChannel::Green};
        if (gloss.index >= 0)
            m_.surface.roughness = {
                1, textures_.add(gloss, ColorSpace::Linear, where_, Double3(1), glossiness),
                TextureChannel::Green};
    }

    void read_ior(const tinygltf::Value& e) {
        m_.ior = number_in(e, "ior", kUsualIor);
        // 0 stands for a surface that reflects all light at every angle.
        reflects_all_ = m_.ior < 1;
        if (reflects_all_) m_.ior = kUsualIor;
        m_.ior = std::min(m_.ior, 100.0);
        if (reflects_all_) m_.surface.specular_color.color = Double3(1 / kUsualF0);
    }

    void read_specular(const tinygltf::Value& e) {
        m_.surface.specular =
            number_of(e, "specularFactor", 1, "specularTexture", TextureChannel::Alpha);
        const Double3 factor = vector_in(e, "specularColorFactor", Double3(1));
        m_.surface.specular_color =
            color(reflects_all_ ? factor / kUsualF0 : factor, use_in(e, "specularColorTexture"));
    }

    void read_transmission() {
        PrincipledSurface& s = m_.surface;
        if (const auto* e = extension("KHR_materials_transmission"))
            s.transmission =
                number_of(*e, "transmissionFactor", 0, "transmissionTexture", TextureChannel::Red);
        if (const auto* e = extension("KHR_materials_diffuse_transmission")) {
            s.diffuse_transmission = number_of(*e, "diffuseTransmissionFactor", 0,
                                               "diffuseTransmissionTexture", TextureChannel::Alpha);
            s.diffuse_transmission_color =
                color(vector_in(*e, "diffuseTransmissionColorFactor", Double3(1)),
                      use_in(*e, "diffuseTransmissionColorTexture"));
        }
        if (const auto* e = extension("KHR_materials_volume")) {
            s.thin = !(number_in(*e, "thicknessFactor", 0) > 0);
            const double distance = number_in(*e, "attenuationDistance", 0);
            s.attenuation_distance = distance > 0 && std::isfinite(distance) ? distance : 0;
            s.attenuation_color =
                glm::clamp(vector_in(*e, "attenuationColor", Double3(1)), 0.0, 1.0);
        }
        if (const auto* e = extension("KHR_materials_dispersion"))
            s.dispersion = std::clamp(number_in(*e, "dispersion", 0), 0.0, 100.0);
    }

    void read_coat(const tinygltf::Value& e) {
        PrincipledSurface& s = m_.surface;
        s.coat = number_of(e, "clearcoatFactor", 0, "clearcoatTexture", TextureChannel::Red);
        s.coat_roughness = number_of(e, "clearcoatRoughnessFactor", 0, "clearcoatRoughnessTexture",
                                     TextureChannel::Green);
        const TextureUse normal = use_in(e, "clearcoatNormalTexture");
        s.coat_normal = linear(normal);
        s.coat_normal_scale = normal.scale;
    }

    void read_sheen(const tinygltf::Value& e) {
        m_.surface.sheen_color =
            color(vector_in(e, "sheenColorFactor", Double3(0)), use_in(e, "sheenColorTexture"));
        m_.surface.sheen_roughness =
            number_of(e, "sheenRoughnessFactor", 0, "sheenRoughnessTexture", TextureChannel::Alpha);
    }

    void read_anisotropy(const tinygltf::Value& e) {
        const TextureUse texture = use_in(e, "anisotropyTexture");
        m_.surface.anisotropy =
            number_of(e, "anisotropyStrength", 0, "anisotropyTexture", TextureChannel::Blue);
        m_.surface.anisotropy_rotation = number_in(e, "anisotropyRotation", 0) * kDegrees;
        if (texture.index >= 0)
            content_.unsupported.push_back(fmt::format(
                "Material \"{}\": of its anisotropy texture the strength is taken, not the "
                "direction.",
                m_.name));
    }

    void read_iridescence(const tinygltf::Value& e) {
        PrincipledSurface& s = m_.surface;
        s.iridescence =
            number_of(e, "iridescenceFactor", 0, "iridescenceTexture", TextureChannel::Red);
        s.iridescence_ior = std::clamp(number_in(e, "iridescenceIor", 1.3), 1.0, 10.0);
        s.iridescence_thickness_low =
            std::clamp(number_in(e, "iridescenceThicknessMinimum", 100), 0.0, 1e5);
        s.iridescence_thickness =
            number(std::clamp(number_in(e, "iridescenceThicknessMaximum", 400), 0.0, 1e5),
                   use_in(e, "iridescenceThicknessTexture"), TextureChannel::Green);
    }

    // Black, emitting the base colour; the colour's texture stays for its alpha.
    void make_unlit() {
        m_.emits = true;
        m_.emission = m_.color;
        m_.strength = 1;
        m_.color = color(Double3(0), base_);
        m_.surface = PrincipledSurface{};
        m_.surface.specular.value = 0;
        m_.surface.roughness.value = 1;
        content_.unsupported.push_back(
            fmt::format("Material \"{}\" is unlit: it becomes a light of its colour.", m_.name));
    }

    const tinygltf::Material& source_;
    std::string where_;
    GltfTextures& textures_;
    ModelContent& content_;
    Material m_;
    TextureUse base_;
    Double3 base_factor_{1, 1, 1};
    bool reflects_all_ = false;
};

}  // namespace

void add_materials(const GltfDocument& document, GltfTextures& textures, ModelContent& content) {
    UniqueNames paths;
    const auto& materials = document.model.materials;
    for (size_t i = 0; i < materials.size(); ++i) {
        const std::string name =
            materials[i].name.empty() ? fmt::format("material {}", i) : materials[i].name;
        Material m = MaterialReader(materials[i], paths.add(path_piece(name)),
                                    document.place("materials", i), textures, content)
                         .read();
        m.id = MaterialId{static_cast<uint32_t>(i + 1)};
        content.materials.push_back(std::move(m));
    }
}

MaterialId default_material(ModelContent& content, size_t materials_of_file) {
    const MaterialId id{static_cast<uint32_t>(materials_of_file + 1)};
    if (content.materials.size() > materials_of_file) return id;
    UniqueNames paths;
    for (const Material& m : content.materials)
        paths.add(m.part.path);
    Material m;
    m.id = id;
    m.kind = MaterialKind::Principled;
    m.name = m.part.path = paths.add("default");
    m.color.color = Double3(1);
    m.surface.metallic.value = 1;
    m.surface.roughness.value = 1;
    content.materials.push_back(std::move(m));
    return id;
}

}  // namespace tp
