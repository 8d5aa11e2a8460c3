#include "scene_fields.h"
#include "scene_reader.h"
#include "scene_writer.h"
#include "whole_file.h"

#include <teapath/core/error.h>
#include <teapath/core/log.h>
#include <teapath/io/image_file.h>
#include <teapath/io/scene_file.h>
#include <teapath/scene/validate.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace tp {
namespace {

namespace fs = std::filesystem;

constexpr uintmax_t kMaxFileBytes = uintmax_t{1} << 30;

// Loads each image once; a missing one is a warning, and stays null.
void load_images(Scene& scene, const fs::path& folder) {
    std::map<std::string, std::shared_ptr<const Image>> loaded;
    const auto load = [&](ImageFile& file) {
        const auto [entry, is_new] = loaded.try_emplace(file.path);
        if (is_new) {
            try {
                entry->second = std::make_shared<const Image>(read_image(folder / file.path));
            } catch (const Error& error) {
                log_warning("{}; shown as cyan", error.what());
            }
        }
        file.image = entry->second;
    };
    for (Texture& texture : scene.textures)
        if (texture.kind == TextureKind::Image) load(texture.file);
    if (scene.background.kind == BackgroundKind::Image) load(scene.background.file);
}

void check_problems(const Scene& scene, const std::string& name) {
    for (const Problem& problem : validate(scene)) {
        const std::string where = problem.where.empty() ? name : name + ": " + problem.where;
        if (problem.fatal) throw Error(ErrorKind::Input, problem.what, where, problem.remedy);
        log_warning("{}: {}", where, problem.what);
    }
}

Scene scene_of(const Json& json, const std::string& name) {
    ReadState state;
    state.file = name;
    SceneReader reader(state, json, "");
    // The reader adds what is inline to state.scene while its fields are read into it.
    scene_fields(reader, state.scene);
    reader.finish();
    return std::move(state.scene);
}

// `scene` with the pixels that `loaded` has for the same paths.
Scene with_images_of(const Scene& loaded, Scene scene) {
    std::map<std::string, std::shared_ptr<const Image>> images;
    for (const Texture& texture : loaded.textures)
        images[texture.file.path] = texture.file.image;
    images[loaded.background.file.path] = loaded.background.file.image;
    const auto fill = [&](ImageFile& file) {
        if (const auto found = images.find(file.path); found != images.end())
            file.image = found->second;
    };
    for (Texture& texture : scene.textures)
        fill(texture.file);
    fill(scene.background.file);
    return scene;
}

Json json_of(const Scene& scene) {
    const WriteState state(scene);
    SceneWriter writer(state);
    Scene copy = scene;
    scene_fields(writer, copy);
    Json json = writer.take();
    for (const char* key : {"name", "description"})
        if (json[key] == "") json.erase(key);
    return json;
}

}  // namespace

Scene parse_scene(std::string_view text, const fs::path& folder, const std::string& name) {
    Scene scene = scene_of(parse_json(text, name), name);
    check_problems(scene, name);
    load_images(scene, folder);
    return scene;
}

Scene load_scene(const fs::path& file) {
    return parse_scene(read_whole_file(file, "a scene file (.json)", kMaxFileBytes),
                       file.parent_path(), file.string());
}

std::string scene_text(const Scene& scene) {
    return pretty_json(json_of(scene)) + "\n";
}

void save_scene(const Scene& scene, const fs::path& file) {
    write_whole_file(file, scene_text(scene));
}

Scene with_setting(const Scene& scene, std::string_view path, std::string_view value) {
    // A value is JSON; a bare word is a string.
    Json parsed = Json::parse(value, nullptr, false);
    if (parsed.is_discarded()) parsed = std::string(value);

    Json json = json_of(scene);
    Json* place = &json;
    size_t start = 0;
    for (;;) {
        const size_t end = std::min(path.find('.', start), path.size());
        std::string key(path.substr(start, end - start));
        if (key.empty())
            throw Error(ErrorKind::Usage, "the path has an empty part",
                        fmt::format("--set {}", path), "for example render.max_depth=8");
        if (place->is_array()) {
            char* rest = nullptr;
            const unsigned long index = std::strtoul(key.c_str(), &rest, 10);
            if (*rest != '\0' || index >= place->size())
                throw Error(ErrorKind::Usage, fmt::format("there is no element \"{}\"", key),
                            fmt::format("--set {}", path),
                            fmt::format("the list has {} elements, from 0", place->size()));
            place = &(*place)[index];
        } else if (place->is_object() || place->is_null()) {
            place = &(*place)[key];
        } else {
            throw Error(ErrorKind::Usage, fmt::format("\"{}\" is inside a plain value", key),
                        fmt::format("--set {}", path));
        }
        if (end == path.size()) break;
        start = end + 1;
    }
    *place = std::move(parsed);
    try {
        Scene changed = scene_of(json, "--set " + std::string(path));
        check_problems(changed, "--set " + std::string(path));
        return with_images_of(scene, std::move(changed));
    } catch (const Error& error) {
        throw Error(ErrorKind::Usage, error.what());
    }
}

}  // namespace tp
