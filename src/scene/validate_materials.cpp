// Checks of textures and materials; what has no name is called by the first place that uses it.
#include "problem_list.h"

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
        const auto use = [&](const TexturedColor& c, const auto& user, const char* key) {
            if (c.texture) first_user_.try_emplace(c.texture, place_of(user) + "." + key);
        };
        for (const Material& m : scene_.materials) {
            use(m.color, m, "color");
            use(m.emission, m, "emission");
        }
        // An inline checker stands before what is inline in it.
        for (const Texture& t : scene_.textures) {
            use(t.even, t.id, "even");
            use(t.odd, t.id, "odd");
        }
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

    void check_color(const TexturedColor& c, const Place& where) {
        problems_.color(where, c.color);
        if (c.texture && !textures_.count(c.texture))
            problems_.fatal(where, "the texture does not exist", "choose another");
    }

    void check_texture(const Texture& t, const Place& where) {
        if (t.kind == TextureKind::Constant) problems_.color(where / "color", t.color);
        if (t.kind == TextureKind::Image) problems_.finite(where / "repeat", t.repeat);
        if (t.kind != TextureKind::Checker) return;
        check_color(t.even, where / "even");
        check_color(t.odd, where / "odd");
        problems_.finite(where / "cells", t.cells);
        problems_.finite(where / "frequency", t.frequency);
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
        }
        problems_.in_range(where / "opacity", m.opacity, 0.0, 1.0);
        problems_.color(where / "pass_through", m.pass_through);
        if (m.kind == MaterialKind::Metal) problems_.in_range(where / "fuzz", m.fuzz, 0.0, 1.0);
        if (m.kind == MaterialKind::Dielectric) {
            problems_.in_range(where / "ior", m.ior, 0.01, 100.0);
            problems_.in_range(where / "exterior_ior", m.exterior_ior, 0.01, 100.0);
        }
        const Double3& c = m.color.color;
        const bool reflects = m.kind != MaterialKind::DiffuseLight && !m.color.texture;
        if (reflects && (c.x > 1 || c.y > 1 || c.z > 1))
            problems_.warn(where / "color",
                           "the colour is above 1: the surface gives back more light than it gets");
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
