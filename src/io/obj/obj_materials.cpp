#include "obj_materials.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {
namespace {

double share(double x) {
    return x > 0 ? std::min(x, 1.0) : 0.0;
}

// A colour of the file, from 0 upwards and finite.
Double3 color_of(const tinyobj::real_t (&c)[3]) {
    Double3 color;
    for (int i = 0; i < 3; ++i)
        color[i] = std::isfinite(c[i]) ? std::max(double{c[i]}, 0.0) : 0.0;
    return color;
}

double largest(Double3 c) {
    return std::max({c.x, c.y, c.z});
}

class MtlReader {
public:
    MtlReader(const MtlMaterial& source, ObjTextures& textures)
        : m_(source.values), said_(source.said), textures_(textures) {}

    Material read() {
        out_.kind = MaterialKind::Principled;
        out_.ior = m_.ior > 1 && m_.ior < 100 ? double{m_.ior} : 1.5;
        read_color();
        read_opacity();
        read_reflection();
        read_physical();
        read_emission();
        read_normals();
        return std::move(out_);
    }

private:
    bool says(const char* word) const { return said_.count(word) > 0; }

    TexturedNumber number(double value, const std::string& file,
                          const tinyobj::texture_option_t& options) {
        return {value, textures_.add(file, options, ColorSpace::Linear), TextureChannel::Red};
    }

    // Exporters leave Kd black, or out, where an image says it all.
    void read_color() {
        Double3 color = color_of(m_.diffuse);
        const bool has_image = !m_.diffuse_texname.empty();
        if (has_image && (color == Double3(0) || !says("Kd"))) color = Double3(1);
        const bool same = m_.alpha_texname == m_.diffuse_texname;
        out_.color = {color, textures_.add(m_.diffuse_texname, m_.diffuse_texopt, ColorSpace::Srgb,
                                           color, same ? std::string() : m_.alpha_texname)};
    }

    // Models of refraction (4, 6, 7, 9) are glass, the others are less than whole.
    void read_opacity() {
        const double opacity = share(m_.dissolve);
        const Double3 filter = color_of(m_.transmittance);
        const bool refracts = m_.illum == 4 || m_.illum == 6 || m_.illum == 7 || m_.illum == 9;
        const double through = opacity < 1 ? 1 - opacity : largest(filter) > 0 ? 1.0 : 0.0;
        if (refracts && through > 0) {
            out_.surface.transmission.value = through;
            out_.surface.thin = false;
            if (!out_.color.texture && largest(filter) > 0)
                out_.color.color = glm::min(filter, Double3(1));
            else if (!out_.color.texture && out_.color.color == Double3(0))
                out_.color.color = Double3(1);
            return;
        }
        out_.opacity = opacity;
        const bool lets_through = opacity < 1 || !m_.alpha_texname.empty();
        out_.alpha = lets_through ? AlphaMode::Blend : AlphaMode::Opaque;
    }

    void read_reflection() {
        PrincipledSurface& s = out_.surface;
        const double exponent =
            std::isfinite(m_.shininess) ? std::max(double{m_.shininess}, 0.0) : 0.0;
        s.roughness.value = share(std::sqrt(std::sqrt(2 / (exponent + 2))));
        const Double3 specular = color_of(m_.specular);
        const double most = largest(specular);
        const bool is_mirror = m_.illum == 3 || m_.illum == 5 || m_.illum == 8;
        if (is_mirror && most > 0 && out_.color.color == Double3(0) && !out_.color.texture) {
            s.metallic.value = 1;
            out_.color.color = glm::min(specular, Double3(1));
            if (!says("Ns")) s.roughness.value = 0;
            return;
        }
        if (!says("Ks")) return;
        // 0.5 stands for an ordinary dielectric, as exporters write it; the colour is its hue.
        s.specular.value = share(2 * most);
        if (most > 0) s.specular_color.color = specular / most;
    }

    void read_physical() {
        PrincipledSurface& s = out_.surface;
        if (says("Pr") || !m_.roughness_texname.empty())
            s.roughness = number(says("Pr") ? share(m_.roughness) : 1, m_.roughness_texname,
                                 m_.roughness_texopt);
        if (says("Pm") || !m_.metallic_texname.empty())
            s.metallic = number(says("Pm") ? share(m_.metallic) : 1, m_.metallic_texname,
                                m_.metallic_texopt);
        s.sheen_color.color = Double3(share(m_.sheen));
        s.coat.value = share(m_.clearcoat_thickness);
        s.coat_roughness.value = share(m_.clearcoat_roughness);
        s.anisotropy.value = share(m_.anisotropy);
        s.anisotropy_rotation = share(m_.anisotropy_rotation) * 360;
    }

    void read_emission() {
        Double3 color = color_of(m_.emission);
        const bool has_image = !m_.emissive_texname.empty();
        if (has_image && color == Double3(0)) color = Double3(1);
        if (color == Double3(0)) return;
        out_.emits = true;
        out_.emission = {
            color, textures_.add(m_.emissive_texname, m_.emissive_texopt, ColorSpace::Srgb, color)};
    }

    void read_normals() {
        const bool has_normals = !m_.normal_texname.empty();
        const auto& options = has_normals ? m_.normal_texopt : m_.bump_texopt;
        out_.surface.normal = textures_.add(has_normals ? m_.normal_texname : m_.bump_texname,
                                            options, ColorSpace::Linear);
        const double scale = options.bump_multiplier;
        out_.surface.normal_scale = std::isfinite(scale) && scale != 0 ? scale : 1.0;
    }

    const tinyobj::material_t& m_;
    const std::set<std::string>& said_;
    ObjTextures& textures_;
    Material out_;
};

}  // namespace

Material material_of(const MtlMaterial& source, ObjTextures& textures) {
    return MtlReader(source, textures).read();
}

}  // namespace tp
