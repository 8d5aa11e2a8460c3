// Checks of textures and materials; what has no name is called by the first place that uses it.
#include "problem_list.h"

#include <teapath/scene/texture_uses.h>

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

namespace tp {
namespace {

// Deeper nests of checkers would be a mistake, and would cost a step of each look-up.
constexpr int kMaxCheckerNesting = 64;

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
        if (t.kind == TextureKind::Constant) problems_.color(where / "color", t.color);
        if (t.kind == TextureKind::Image) check_image(t, where);
        if (t.kind != TextureKind::Checker) return;
        check_color(t.even, where / "even");
        check_color(t.odd, where / "odd");
        problems_.finite(where / "cells", t.cells);
        problems_.finite(where / "frequency", t.frequency);
    }

    void check_image(const Texture& t, const Place& where) {
        problems_.in_range(where / "uv_set", t.uv_set, 0, kUvSets - 1);
        problems_.finite(where / "repeat", t.repeat);
        problems_.finite(where / "uv_rotation", t.uv_rotation);
        problems_.finite(where / "uv_offset", t.uv_offset);
        problems_.color(where / "tint", t.tint);
    }

    // The checkers directly inside a checker.
    std::vector<TextureId> inner_checkers(const Texture& t) const {
        std::vector<TextureId> inner;
        if (t.kind != TextureKind::Checker) return inner;
        for (const TextureId id : {t.even.texture, t.odd.texture})
            if (const auto found = textures_.find(id);
                found != textures_.end() && found->second->kind == TextureKind::Checker)
                inner.push_back(id);
        return inner;
    }

    // Levels of each checker, from those without inner ones upwards; a circle is never reached.
    void check_nesting() {
        std::map<TextureId, std::vector<TextureId>> outer;
        std::map<TextureId, size_t> open;
        std::map<TextureId, int> levels;
        std::vector<TextureId> ready;
        for (const Texture& t : scene_.textures) {
            if (t.kind != TextureKind::Checker) continue;
            const std::vector<TextureId> inner = inner_checkers(t);
            for (const TextureId id : inner)
                outer[id].push_back(t.id);
            if (inner.empty()) ready.push_back(t.id);
            if (!inner.empty()) open[t.id] = inner.size();
        }
        int deepest = 0;
        while (!ready.empty()) {
            const TextureId id = ready.back();
            ready.pop_back();
            const int level = levels[id] + 1;
            if (level > kMaxCheckerNesting && deepest <= kMaxCheckerNesting)
                problems_.fatal(place_of(id), "the checkers nest too deeply",
                                fmt::format("at most {} levels", kMaxCheckerNesting));
            deepest = std::max(deepest, level);
            for (const TextureId o : outer[id]) {
                levels[o] = std::max(levels[o], level);
                if (--open[o] == 0) {
                    open.erase(o);
                    ready.push_back(o);
                }
            }
        }
        if (!open.empty()) report_circle(open);
    }

    // Of the checkers that are in a circle or hold one, names one that is in it.
    void report_circle(const std::map<TextureId, size_t>& open) {
        std::set<TextureId> walked;
        TextureId id = open.begin()->first;
        while (walked.insert(id).second)
            for (const TextureId inner : inner_checkers(*textures_[id]))
                if (open.count(inner)) id = inner;
        problems_.fatal(place_of(id), "the texture contains itself",
                        "break the circle of checkers");
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
