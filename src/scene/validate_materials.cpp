// Checks of textures and materials; what has no name is called by the first place that uses it.
#include "problem_list.h"

#include <teapath/core/tea.h>
#include <teapath/scene/texture_uses.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>

namespace tp {
namespace {

class MaterialChecker {
public:
    MaterialChecker(const Scene& scene, ProblemList& problems)
        : scene_(scene), problems_(problems) {
        for (const Texture& t : scene.textures)
            textures_[t.id] = &t;
        find_users();
    }

    void run() {
        for (const Texture& t : scene_.textures)
            check_texture(t, place_of(t.id));
        for (const Material& m : scene_.materials)
            check_material(m, place_of(m));
        check_nesting();
    }

private:
    // The first object that uses each material, and the first user of each texture.
    void find_users() {
        for (size_t i = 0; i < scene_.objects.size(); ++i)
            first_object_.try_emplace(scene_.objects[i].material.value, i);
        const auto use = [&](TextureId id, const auto& user, const char* key) {
            if (id) first_user_.try_emplace(id, place_of(user) + "." + key);
        };
        for (const Material& m : scene_.materials)
            for_each_slot(
                m, [&](const char* key, const auto& slot) { use(texture_in(slot), m, key); });
        // An inline checker stands before what is inline in it.
        for (const Texture& t : scene_.textures)
            for_each_slot(
                t, [&](const char* key, const auto& slot) { use(texture_in(slot), t.id, key); });
    }

    std::string place_of(const Material& m) const {
        if (!m.name.empty()) return "materials." + m.name;
        const auto object = first_object_.find(m.id.value);
        return object == first_object_.end() ? "materials"
                                             : fmt::format("objects[{}].material", object->second);
    }
    std::string place_of(TextureId id) const {
        const auto texture = textures_.find(id);
        if (texture != textures_.end() && !texture->second->name.empty())
            return "textures." + texture->second->name;
        const auto user = first_user_.find(id);
        return user == first_user_.end() ? "textures" : user->second;
    }

    void check_texture_id(TextureId id, const Place& where) {
        if (id && !textures_.count(id))
            problems_.fatal(where, "the texture does not exist", "choose another");
    }

    void check_color(const TexturedColor& c, const Place& where) {
        problems_.color(where, c.color);
        check_texture_id(c.texture, where);
    }

    void check_number(const TexturedNumber& n, const Place& where) {
        problems_.in_range(where, n.value, 0.0, 1.0);
        check_texture_id(n.texture, where);
    }

    void check_texture(const Texture& t, const Place& where) {
        const auto colors = [&](const char* first, const char* second) {
            check_color(*pair_of(t).first, where / first);
            check_color(*pair_of(t).second, where / second);
        };
        switch (t.kind) {
            case TextureKind::Constant: problems_.color(where / "color", t.color); break;
            case TextureKind::Image: check_image(t, where); break;
            case TextureKind::Checker:
                colors("even", "odd");
                problems_.finite(where / "cells", t.cells);
                problems_.finite(where / "frequency", t.frequency);
                break;
            case TextureKind::Noise:
                colors("low", "high");
                problems_.in_range(where / "contrast", t.contrast, 0.0, 100.0);
                check_noise(t, where);
                break;
            case TextureKind::Marble:
                colors("stone", "vein");
                problems_.in_range(where / "distortion", t.distortion, 0.0, 100.0);
                problems_.in_range(where / "vein_power", t.vein_power, 0.1, 100.0);
                check_noise(t, where);
                break;
            case TextureKind::Wood:
                colors("early", "late");
                problems_.in_range(where / "distortion", t.distortion, 0.0, 100.0);
                problems_.in_range(where / "grain", t.grain, 0.0, 1.0);
                check_noise(t, where);
                break;
            case TextureKind::Brick:
                colors("brick", "mortar");
                check_brick(t, where);
                break;
        }
    }

    void check_hash(const Texture& t, const Place& where) {
        problems_.in_range(where / "seed", t.seed, 0, std::numeric_limits<int>::max());
        problems_.in_range(where / "tea_rounds", t.tea_rounds, kMinNoiseRounds, kMaxTeaRounds);
    }

    void check_noise(const Texture& t, const Place& where) {
        problems_.finite(where / "scale", t.scale);
        problems_.in_range(where / "octaves", t.octaves, 1, kMaxOctaves);
        problems_.in_range(where / "lacunarity", t.lacunarity, 1.0, 8.0);
        problems_.in_range(where / "gain", t.gain, 0.0, 1.0);
        check_hash(t, where);
    }

    void check_brick(const Texture& t, const Place& where) {
        const Place size = where / "brick_size";
        problems_.in_range(size[0], t.brick_size.x, 1e-6, 1e6);
        problems_.in_range(size[1], t.brick_size.y, 1e-6, 1e6);
        problems_.in_range(where / "mortar_width", t.mortar_width, 0.0, 1e6);
        problems_.in_range(where / "mortar_blend", t.mortar_blend, 0.0, 10.0);
        problems_.in_range(where / "row_offset", t.row_offset, 0.0, 1.0);
        problems_.in_range(where / "variation", t.variation, 0.0, 1.0);
        check_hash(t, where);
    }

    void check_image(const Texture& t, const Place& where) {
        problems_.in_range(where / "uv_set", t.uv_set, 0, kUvSets - 1);
        problems_.finite(where / "repeat", t.repeat);
        problems_.finite(where / "uv_rotation", t.uv_rotation);
        problems_.finite(where / "uv_offset", t.uv_offset);
        problems_.color(where / "tint", t.tint);
        problems_.in_range(where / "sharpness", t.sharpness, 0.1, 64.0);
        if (t.projection == TextureProjection::Triplanar && t.space == TextureSpace::Uv)
            problems_.fatal(where / "space", "a triplanar image has no texture coordinates",
                            "choose object or world");
    }

    // The textures of two colours directly inside such a texture.
    std::vector<TextureId> inner_pairs(const Texture& t) const {
        std::vector<TextureId> inner;
        const TexturePair pair = pair_of(t);
        if (!pair.first) return inner;
        for (const TextureId id : {pair.first->texture, pair.second->texture})
            if (const auto found = textures_.find(id);
                found != textures_.end() && pair_of(*found->second).first)
                inner.push_back(id);
        return inner;
    }

    // How deep a texture goes: levels of any kind, and levels whose both colours are looked up.
    struct Levels {
        int all = 0, blends = 0;
    };

    // Levels of each texture, from those without inner ones upwards; a circle is never reached.
    void check_nesting() {
        std::map<TextureId, std::vector<TextureId>> outer;
        std::map<TextureId, size_t> open;
        std::map<TextureId, Levels> inside;  // of what is in the texture
        std::vector<TextureId> ready;
        for (const Texture& t : scene_.textures) {
            if (!pair_of(t).first) continue;
            const std::vector<TextureId> inner = inner_pairs(t);
            for (const TextureId id : inner)
                outer[id].push_back(t.id);
            if (inner.empty()) ready.push_back(t.id);
            if (!inner.empty()) open[t.id] = inner.size();
        }
        Levels deepest;
        while (!ready.empty()) {
            const TextureId id = ready.back();
            ready.pop_back();
            Levels levels = inside[id];
            ++levels.all;
            levels.blends += is_blend(textures_[id]->kind);
            check_depth(id, levels, deepest);
            deepest.all = std::max(deepest.all, levels.all);
            deepest.blends = std::max(deepest.blends, levels.blends);
            for (const TextureId o : outer[id]) {
                inside[o].all = std::max(inside[o].all, levels.all);
                inside[o].blends = std::max(inside[o].blends, levels.blends);
                if (--open[o] == 0) {
                    open.erase(o);
                    ready.push_back(o);
                }
            }
        }
        if (!open.empty()) report_circle(open);
    }

    // Names the first texture that goes too deep, but none that has such a one inside.
    void check_depth(TextureId id, const Levels& levels, const Levels& deepest) {
        if (levels.all > kMaxTextureNesting && deepest.all <= kMaxTextureNesting)
            problems_.fatal(place_of(id), "the textures nest too deeply",
                            fmt::format("at most {} levels", kMaxTextureNesting));
        if (levels.blends > kMaxBlendNesting && deepest.blends <= kMaxBlendNesting)
            problems_.fatal(place_of(id), "the textures that mix colours nest too deeply",
                            fmt::format("at most {} levels of noise, marble, wood and brick",
                                        kMaxBlendNesting));
    }

    // Of the textures that are in a circle or hold one, names one that is in it.
    void report_circle(const std::map<TextureId, size_t>& open) {
        std::set<TextureId> walked;
        TextureId id = open.begin()->first;
        while (walked.insert(id).second)
            for (const TextureId inner : inner_pairs(*textures_[id]))
                if (open.count(inner)) id = inner;
        problems_.fatal(place_of(id), "the texture contains itself",
                        "break the circle of textures");
    }

    void check_material(const Material& m, const Place& where) {
        if (m.kind != MaterialKind::DiffuseLight) check_color(m.color, where / "color");
        if (m.emits || m.kind == MaterialKind::DiffuseLight) {
            check_color(m.emission, where / "emission");
            problems_.not_negative(where / "strength", m.strength, "strength");
            if (!m.emission.texture)
                problems_.radiance(where / "emission", m.emission.color, m.strength);
            problems_.in_range(where / "spot_angle", m.spot_angle, 0.1, 180.0);
            problems_.in_range(where / "spot_blend", m.spot_blend, 0.0, 1.0);
        }
        problems_.in_range(where / "alpha_cutoff", m.alpha_cutoff, 0.0, 1.0);
        problems_.in_range(where / "opacity", m.opacity, 0.0, 1.0);
        problems_.color(where / "pass_through", m.pass_through);
        if (m.kind == MaterialKind::Metal) problems_.in_range(where / "fuzz", m.fuzz, 0.0, 1.0);
        if (m.kind == MaterialKind::Dielectric) {
            problems_.in_range(where / "ior", m.ior, 0.01, 100.0);
            problems_.in_range(where / "exterior_ior", m.exterior_ior, 0.01, 100.0);
        }
        if (m.kind == MaterialKind::Conductor) {
            for (size_t i = 0; i < 3; ++i) {
                const auto channel = static_cast<Double3::length_type>(i);
                problems_.in_range((where / "eta")[i], m.eta[channel], 0.01, 100.0);
                problems_.in_range((where / "k")[i], m.k[channel], 0.0, 100.0);
            }
        }
        if (m.kind == MaterialKind::Dielectric || m.kind == MaterialKind::Conductor)
            check_number(m.roughness, where / "roughness");
        if (m.kind == MaterialKind::Principled) {
            problems_.in_range(where / "ior", m.ior, 1.0, 100.0);
            check_surface(m.surface, where);
        }
        const Double3& c = m.color.color;
        const bool reflects = m.kind != MaterialKind::DiffuseLight && !m.color.texture;
        if (reflects && (c.x > 1 || c.y > 1 || c.z > 1))
            problems_.warn(where / "color",
                           "the colour is above 1: the surface gives back more light than it gets");
    }

    void check_surface(const PrincipledSurface& s, const Place& where) {
        check_number(s.metallic, where / "metallic");
        check_number(s.roughness, where / "roughness");
        check_number(s.specular, where / "specular");
        check_color(s.specular_color, where / "specular_color");
        check_number(s.anisotropy, where / "anisotropy");
        problems_.finite(where / "anisotropy_rotation", s.anisotropy_rotation);
        check_number(s.transmission, where / "transmission");
        problems_.color(where / "attenuation_color", s.attenuation_color);
        problems_.not_negative(where / "attenuation_distance", s.attenuation_distance, "distance");
        problems_.in_range(where / "dispersion", s.dispersion, 0.0, 100.0);
        check_number(s.diffuse_transmission, where / "diffuse_transmission");
        check_color(s.diffuse_transmission_color, where / "diffuse_transmission_color");
        check_number(s.coat, where / "coat");
        check_number(s.coat_roughness, where / "coat_roughness");
        check_texture_id(s.coat_normal, where / "coat_normal");
        problems_.finite(where / "coat_normal_scale", s.coat_normal_scale);
        check_film(s, where);
        check_color(s.sheen_color, where / "sheen_color");
        check_number(s.sheen_roughness, where / "sheen_roughness");
        check_texture_id(s.normal, where / "normal");
        problems_.finite(where / "normal_scale", s.normal_scale);
        check_texture_id(s.bump, where / "bump");
        problems_.finite(where / "bump_scale", s.bump_scale);
    }

    void check_film(const PrincipledSurface& s, const Place& where) {
        check_number(s.iridescence, where / "iridescence");
        problems_.in_range(where / "iridescence_ior", s.iridescence_ior, 1.0, 10.0);
        problems_.in_range(where / "iridescence_thickness_low", s.iridescence_thickness_low, 0.0,
                           1e5);
        problems_.in_range(where / "iridescence_thickness", s.iridescence_thickness.value, 0.0,
                           1e5);
        check_texture_id(s.iridescence_thickness.texture, where / "iridescence_thickness");
    }

    const Scene& scene_;
    ProblemList& problems_;
    std::map<TextureId, const Texture*> textures_;
    std::unordered_map<uint32_t, size_t> first_object_;  // by material
    std::map<TextureId, std::string> first_user_;
};

}  // namespace

void check_textures_and_materials(const Scene& scene, ProblemList& problems) {
    MaterialChecker(scene, problems).run();
}

}  // namespace tp
