// Reading what stands in a scene file by name or in a list of its own: cameras, textures,
// materials.
#include "scene_fields.h"
#include "scene_reader.h"

#include <fmt/format.h>

namespace tp {

void SceneReader::read_camera(const Json& json, const std::string& path, Scene& scene) {
    SceneReader inner(state_, json, path);
    Camera camera;
    camera.id = {static_cast<uint32_t>(scene.cameras.size()) + 1};
    camera_fields(inner, camera);
    inner.finish();
    scene.cameras.push_back(std::move(camera));
}

void SceneReader::cameras(Scene& scene) {
    const Json* one = find("camera");
    const Json* many = find("cameras");
    if (one && many)
        fail(path_, "both \"camera\" and \"cameras\" are given", "move the camera into the list");
    if (one) read_camera(*one, "camera", scene);
    if (many) {
        expect_array(*many, "cameras");
        for (size_t i = 0; i < many->size(); ++i)
            read_camera((*many)[i], fmt::format("cameras[{}]", i), scene);
    }
    state_.has_camera = !scene.cameras.empty();
    if (scene.cameras.empty()) {
        Camera camera;
        camera.id = {1};
        scene.cameras.push_back(camera);
    }
    std::string active;
    (*this)("active_camera", active);
    if (!json_.contains("active_camera")) return;
    std::vector<std::string> names;
    for (const Camera& camera : scene.cameras) {
        if (camera.name == active) scene.active_camera = camera.id;
        if (!camera.name.empty()) names.push_back(camera.name);
    }
    if (!scene.active_camera) unknown_name("active_camera", "camera", active, names);
}

TextureId SceneReader::inline_texture(const Json& json, const std::string& path) {
    // The place is taken before the fields are read, which may bring textures of their own.
    const size_t index = state_.scene.textures.size();
    const TextureId id{static_cast<uint32_t>(index) + 1};
    state_.scene.textures.edit().emplace_back();
    SceneReader inner(state_, json, path);
    Texture texture;
    texture_fields(inner, texture);
    inner.finish();
    texture.id = id;
    state_.scene.textures.edit()[index] = std::move(texture);
    return id;
}

void SceneReader::check_name(const std::string& name, const char* key) const {
    if (name.empty()) fail(key, "a name is empty", "others refer to it by its name");
}

void SceneReader::named(const char* key, std::vector<Texture>&) {
    const Json* json = find(key);
    if (!json) return;
    if (!json->is_object())
        fail(key,
             fmt::format("expected an object of textures by name, found {}", type_name(*json)));
    // Names first, so that a texture may use one that stands below it.
    for (const auto& [name, value] : json->items()) {
        check_name(name, key);
        const TextureId id{static_cast<uint32_t>(state_.scene.textures.size()) + 1};
        state_.texture_names[name] = id;
        state_.scene.textures.edit().emplace_back();
    }
    for (const auto& [name, value] : json->items()) {
        SceneReader inner(state_, value, fmt::format("{}.{}", key, name));
        Texture texture;
        texture.id = state_.texture_names[name];
        texture.name = name;
        texture_fields(inner, texture);
        inner.finish();
        state_.scene.textures.edit()[texture.id.value - 1] = std::move(texture);
    }
}

void SceneReader::named(const char* key, std::vector<Material>&) {
    const Json* json = find(key);
    if (!json) return;
    if (!json->is_object())
        fail(key,
             fmt::format("expected an object of materials by name, found {}", type_name(*json)));
    for (const auto& [name, value] : json->items()) {
        check_name(name, key);
        SceneReader inner(state_, value, fmt::format("{}.{}", key, name));
        Material material;
        material_fields(inner, material);
        inner.finish();
        material.id = {static_cast<uint32_t>(state_.scene.materials.size()) + 1};
        material.name = name;
        state_.material_names[name] = material.id;
        state_.scene.materials.edit().push_back(std::move(material));
    }
}

}  // namespace tp
