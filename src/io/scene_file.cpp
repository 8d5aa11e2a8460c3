#include "scene_fields.h"
#include "scene_json.h"
#include "scene_reader.h"
#include "scene_writer.h"
#include "whole_file.h"

#include <teapath/core/error.h>
#include <teapath/core/log.h>
#include <teapath/io/image_file.h>
#include <teapath/io/mesh_file.h>
#include <teapath/io/scene_file.h>
#include <teapath/scene/procedural_mesh.h>
#include <teapath/scene/validate.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace tp {
namespace {

namespace fs = std::filesystem;

constexpr uintmax_t kMaxFileBytes = uintmax_t{1} << 30;

// Calls `f` with every image file that the scene shows.
template <class SceneType, class F>
void for_each_image(SceneType& scene, F&& f) {
    for (auto& texture : elements(scene.textures))
        if (texture.kind == TextureKind::Image) f(texture.file);
    if (scene.background.kind == BackgroundKind::Image) f(scene.background.file);
    if (scene.background.backdrop == BackdropKind::Image) f(scene.background.backdrop_file);
}

// Calls `f` with every mesh file that an object shows.
template <class SceneType, class F>
void for_each_mesh(SceneType& scene, F&& f) {
    const auto is_mesh = [](const Object& o) { return std::holds_alternative<MeshShape>(o.shape); };
    // Most scenes have none: their objects stay shared.
    if (std::none_of(scene.objects.begin(), scene.objects.end(), is_mesh)) return;
    for (auto& object : elements(scene.objects))
        if (is_mesh(object)) f(std::get<MeshShape>(object.shape).file);
}

std::shared_ptr<const Mesh> load_mesh(const Scene& scene, const std::string& path,
                                      const std::string& name, ModelCache& models) {
    if (names_part(path)) return models.mesh(path);
    try {
        if (is_procedural(path)) return share(procedural_mesh(path));
        return share(read_mesh(fs::path(scene.origin.folder) / path));
    } catch (const Error& error) {
        log_warning("{}: {}; not shown", name, error.what());
        return nullptr;
    }
}

std::shared_ptr<const Image> load_image(const Scene& scene, const std::string& path,
                                        const std::string& name, ModelCache& models) {
    if (names_part(path)) return models.image(path);
    if (path.empty()) {
        log_warning("{}: a texture has no image yet; shown as cyan", name);
        return nullptr;
    }
    try {
        return std::make_shared<const Image>(read_image(fs::path(scene.origin.folder) / path));
    } catch (const Error& error) {
        log_warning("{}: {}; shown as cyan", name, error.what());
        return nullptr;
    }
}

// A relative path from `from`, turned to start from `to`; the whole path where there is no way.
std::string rebased(const std::string& path, const fs::path& from, const fs::path& to) {
    if (path.empty() || fs::path(path).is_absolute() || path.find("://") != std::string::npos)
        return path;
    const fs::path whole = (from / path).lexically_normal();
    const fs::path relative = whole.lexically_relative(to);
    return (relative.empty() ? whole : relative).generic_string();
}

// The scene as it is written into a file of `folder`.
Scene moved_to(Scene scene, const fs::path& folder) {
    const fs::path from = scene.origin.folder;
    if (from.empty() || from == folder) return scene;
    scene.origin.schema = rebased(scene.origin.schema, from, folder);
    for_each_image(scene, [&](ImageFile& file) { file.path = rebased(file.path, from, folder); });
    for_each_mesh(scene, [&](MeshFile& file) { file.path = rebased(file.path, from, folder); });
    if (!scene.models.empty())
        for (Model& model : scene.models.edit())
            model.path = rebased(model.path, from, folder);
    return scene;
}

// The folder of a file, absolute and without detours.
fs::path folder_of(const fs::path& file) {
    std::error_code error;
    fs::path folder = fs::weakly_canonical(fs::absolute(file).parent_path(), error);
    return error ? fs::absolute(file).parent_path().lexically_normal() : folder;
}

}  // namespace

Scene scene_of_json(const Json& json, const std::string& name, ModelCache& models) {
    ReadState state;
    state.file = name;
    state.load_model = [&](const std::string& path) { return models.content(path); };
    SceneReader reader(state, json, "");
    // The reader adds what is inline to state.scene while its fields are read into it.
    Scene& scene = state.scene;
    scene_fields(reader, scene);
    reader.finish();
    if (!state.has_camera && !scene.models.empty()) {
        const double aspect = static_cast<double>(scene.render.width) / scene.render.height;
        const CameraId id = scene.cameras.front().id;
        scene.cameras.front() = camera_in_front(scene.objects, aspect);
        scene.cameras.front().id = id;
    }
    return std::move(scene);
}

Json json_of_scene(const Scene& scene, bool with_defaults) {
    const WriteState state(scene, with_defaults);
    SceneWriter writer(state);
    Scene copy = scene;
    scene_fields(writer, copy);
    Json json = writer.take();
    if (!with_defaults)
        for (const char* key : {"name", "description"})
            if (json[key] == "") json.erase(key);
    return json;
}

void check_problems(const Scene& scene, const std::string& name, bool warn) {
    for (const Problem& problem : validate(scene)) {
        const std::string where = problem.where.empty() ? name : name + ": " + problem.where;
        if (problem.fatal) throw Error(ErrorKind::Input, problem.what, where, problem.remedy);
        if (warn) log_warning("{}: {}", where, problem.what);
    }
}

void load_images(Scene& scene, const std::string& name, ModelCache& models, const Scene* known) {
    std::map<std::string, std::shared_ptr<const Image>> loaded;
    if (known)
        for_each_image(*known, [&](const ImageFile& file) { loaded[file.path] = file.image; });
    for_each_image(scene, [&](ImageFile& file) {
        if (file.image) return;
        const auto [entry, is_new] = loaded.try_emplace(file.path);
        if (is_new) entry->second = load_image(scene, file.path, name, models);
        file.image = entry->second;
    });
}

void load_meshes(Scene& scene, const std::string& name, ModelCache& models, const Scene* known) {
    std::map<std::string, std::shared_ptr<const Mesh>> loaded;
    if (known) for_each_mesh(*known, [&](const MeshFile& file) { loaded[file.path] = file.mesh; });
    for_each_mesh(scene, [&](MeshFile& file) {
        if (file.mesh) return;
        const auto [entry, is_new] = loaded.try_emplace(file.path);
        if (is_new) entry->second = load_mesh(scene, file.path, name, models);
        file.mesh = entry->second;
    });
}

Scene parse_scene(std::string_view text, const fs::path& folder, const std::string& name,
                  const ModelReadOptions& options) {
    const std::string origin = folder_of(folder / "scene").string();
    ModelCache models(origin, name, nullptr, options);
    Scene scene = scene_of_json(parse_json(text, name), name, models);
    scene.origin.folder = origin;
    check_problems(scene, name);
    load_images(scene, name, models);
    load_meshes(scene, name, models);
    return scene;
}

Model load_model(const fs::path& file, const ModelReadOptions& options) {
    Model model;
    model.name = file.stem().string();
    model.path = file.filename().generic_string();
    model.content = read_content(file, options);
    return model;
}

Scene load_scene(const fs::path& file, const ModelReadOptions& options) {
    if (can_read_model(file)) {
        Scene scene = scene_of_model(load_model(file, options));
        scene.origin.folder = folder_of(file).string();
        check_problems(scene, file.string());
        return scene;
    }
    return parse_scene(read_whole_file(file, "a scene file (.json)", kMaxFileBytes),
                       file.parent_path(), file.string(), options);
}

std::string scene_text(const Scene& scene) {
    return pretty_json(json_of_scene(scene, false)) + "\n";
}

void save_scene(const Scene& scene, const fs::path& file) {
    write_whole_file(file, scene_text(moved_to(scene, folder_of(file))));
}

}  // namespace tp
