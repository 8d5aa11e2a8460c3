#include "scene_writer.h"

#include "scene_fields.h"

#include <teapath/io/shape_types.h>
#include <teapath/scene/texture_uses.h>

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace tp {
namespace {

// A name for each thing that has one or needs one; the second of a name gets a number.
template <class Thing, class Id, class Needs>
void give_names(std::map<Id, std::string>& names, const std::vector<Thing>& things,
                const char* word, Needs&& needs_name) {
    std::set<std::string> taken;
    for (const Thing& thing : things)
        taken.insert(thing.name);
    std::set<std::string> used;
    for (const Thing& thing : things) {
        if (thing.name.empty() && !needs_name(thing.id)) continue;
        std::string name = thing.name;
        const std::string stem = name.empty() ? word : name;
        for (int number = name.empty() ? 1 : 2; name.empty() || used.count(name); ++number) {
            name = fmt::format("{} {}", stem, number);
            if (taken.count(name)) name.clear();
        }
        used.insert(name);
        names[thing.id] = std::move(name);
    }
}

}  // namespace

WriteState::WriteState(const Scene& s, bool defaults) : scene(s), with_defaults(defaults) {
    std::map<TextureId, int> texture_uses;
    std::map<MaterialId, int> material_uses;
    const auto use = [&](const char*, const auto& slot) {
        if (const TextureId id = texture_in(slot)) ++texture_uses[id];
    };
    for (const Texture& t : s.textures) {
        textures[t.id] = &t;
        for_each_slot(t, use);
    }
    for (const Material& m : s.materials) {
        materials[m.id] = &m;
        for_each_slot(m, use);
    }
    for (const Object& o : s.objects)
        if (o.material) ++material_uses[o.material];
    give_names(camera_names, s.cameras, "camera",
               [&](CameraId id) { return id == s.active_camera && s.cameras.front().id != id; });
    for (const Model& m : s.models)
        if (m.content) models.insert(m.id);
    // Things of models are written by name, wherever they are used.
    give_names(texture_names, s.textures.items(), "texture", [&](TextureId id) {
        return texture_uses[id] > 1 || is_of_model(textures[id]->part);
    });
    give_names(material_names, s.materials.items(), "material", [&](MaterialId id) {
        return material_uses[id] > 1 || is_of_model(materials[id]->part);
    });
}

Json SceneWriter::number(double value) {
    if (value == std::floor(value) && std::abs(value) < 1e15 &&
        !(value == 0 && std::signbit(value)))
        return static_cast<int64_t>(value);
    return value;
}

// The shortest decimal that gives the float back.
void SceneWriter::operator()(const char* key, float value) {
    json_[key] = number(std::strtod(fmt::format("{}", value).c_str(), nullptr));
}

void SceneWriter::operator()(const char* key, const std::vector<Double4>& value) {
    Json items = Json::array();
    for (const Double4& v : value)
        items.push_back({number(v.x), number(v.y), number(v.z), number(v.w)});
    json_[key] = std::move(items);
}

void SceneWriter::operator()(const char* key, const TexturedColor& value) {
    if (!value.texture)
        json_[key] = vector(value.color);
    else
        texture(key, value.texture);
}

void SceneWriter::operator()(const char* key, const TexturedNumber& value) {
    if (!value.texture) {
        json_[key] = number(value.value);
        return;
    }
    SceneWriter inner(state_);
    inner("value", value.value);
    inner.texture("texture", value.texture);
    inner("channel", value.channel);
    json_[key] = inner.take();
}

void SceneWriter::texture(const char* key, TextureId value) {
    if (const auto name = state_.texture_names.find(value); name != state_.texture_names.end()) {
        json_[key] = name->second;
        return;
    }
    const auto found = state_.textures.find(value);
    if (found == state_.textures.end()) return;
    Texture texture = *found->second;
    json_[key] = difference(texture, [](auto& v, Texture& t) { texture_fields(v, t); });
}

void SceneWriter::operator()(const char* key, MaterialId value) {
    if (const auto name = state_.material_names.find(value); name != state_.material_names.end()) {
        json_[key] = name->second;
        return;
    }
    const auto found = state_.materials.find(value);
    if (found == state_.materials.end()) return;
    Material material = *found->second;
    json_[key] = difference(material, [](auto& v, Material& m) { material_fields(v, m); });
}

void SceneWriter::matrix(const char* key, const DoubleMat3& value) {
    if (value == DoubleMat3(1)) return;
    Json numbers = Json::array();
    for (int i = 0; i < 9; ++i)
        numbers.push_back(number(value[i / 3][i % 3]));
    json_[key] = std::move(numbers);
}

void SceneWriter::shape(const char* key, Shape& value) {
    SceneWriter inner(state_);
    inner.constant("type", kShapeTypes[value.index()]);
    std::visit([&](auto& s) { shape_fields(inner, s); }, value);
    json_[key] = inner.take();
}

void SceneWriter::cameras(const Scene& scene) {
    std::vector<Camera> cameras = scene.cameras;
    for (Camera& c : cameras)
        if (const auto name = state_.camera_names.find(c.id); name != state_.camera_names.end())
            c.name = name->second;
    if (cameras.size() == 1)
        object("camera", cameras.front(), [](auto& v, Camera& c) { camera_fields(v, c); });
    else
        list("cameras", cameras, [](auto& v, Camera& c) { camera_fields(v, c); });
    if (const auto active = state_.camera_names.find(scene.active_camera);
        active != state_.camera_names.end())
        json_["active_camera"] = active->second;
}

void SceneWriter::named(const char* key, std::vector<Texture>& textures) {
    Json items = Json::object();
    for (Texture& texture : textures) {
        const auto name = state_.texture_names.find(texture.id);
        if (name != state_.texture_names.end() && !state_.is_of_model(texture.part))
            items[name->second] =
                difference(texture, [](auto& v, Texture& t) { texture_fields(v, t); });
    }
    if (!items.empty()) json_[key] = std::move(items);
}

void SceneWriter::named(const char* key, std::vector<Material>& materials) {
    Json items = Json::object();
    for (Material& material : materials) {
        const auto name = state_.material_names.find(material.id);
        if (name != state_.material_names.end() && !state_.is_of_model(material.part))
            items[name->second] =
                difference(material, [](auto& v, Material& m) { material_fields(v, m); });
    }
    if (!items.empty()) json_[key] = std::move(items);
}

Background SceneWriter::default_like(const Background& b) {
    Background standard;
    standard.kind = b.kind;
    return standard;
}

Texture SceneWriter::default_like(const Texture& t) {
    Texture standard;
    standard.kind = t.kind;
    return standard;
}

Material SceneWriter::default_like(const Material& m) {
    return default_material(m.kind);
}

Json SceneWriter::without_defaults(Json json, const Json& standard) {
    Json kept = Json::object();
    for (auto& [key, value] : json.items()) {
        const auto same = standard.find(key);
        // What tells one kind of thing from another stays, and so does every shape.
        const bool always = key == "type" || key == "shape" || key == "file";
        if (always || same == standard.end() || *same != value) kept[key] = std::move(value);
    }
    return kept;
}

}  // namespace tp
