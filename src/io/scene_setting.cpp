// Changing one setting of a scene by its path, as the command line's --set does.
#include "scene_json.h"

#include <teapath/core/error.h>
#include <teapath/core/nearest_name.h>
#include <teapath/io/scene_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace tp {
namespace {

// Where the path stops being understood.
[[noreturn]] void fail(std::string_view path, const std::string& what,
                       const std::string& remedy = {}) {
    throw Error(ErrorKind::Usage, what, fmt::format("--set {}", path), remedy);
}

// Takes parts off the front of a path: keys after dots, elements in brackets or after dots.
class PathReader {
public:
    explicit PathReader(std::string_view path) : path_(path), rest_(path) {}

    bool at_end() const { return rest_.empty(); }

    // The next key of an object: the longest one that it has, since names may hold dots and
    // brackets, else all up to the next dot or bracket.
    std::string next_key(const Json& object) {
        skip_dot();
        std::vector<std::string> keys;
        for (const auto& [key, value] : object.items())
            keys.push_back(key);
        return take_word(keys);
    }

    // The next element of a list, by number or name.
    size_t next_index(const Json& list) {
        const bool bracket = rest_.starts_with('[');
        std::string word;
        if (bracket) {
            const size_t close = rest_.find(']');
            if (close == std::string_view::npos) fail(path_, "a bracket is not closed");
            rest_.remove_prefix(1);
            word = take(close - 1);
            rest_.remove_prefix(1);
        } else {
            skip_dot();
            word = take_word(names_in(list));
        }
        return index_of(word, list);
    }

private:
    void skip_dot() {
        if (rest_.size() < path_.size() && rest_.starts_with('.')) rest_.remove_prefix(1);
    }

    // The longest of `words` that the rest starts with, else all up to the next dot or bracket.
    std::string take_word(const std::vector<std::string>& words) {
        size_t length = std::min(rest_.find_first_of(".["), rest_.size());
        for (const std::string& word : words) {
            const bool ends = rest_.size() == word.size() ||
                              (rest_.size() > word.size() &&
                               (rest_[word.size()] == '.' || rest_[word.size()] == '['));
            if (ends && word.size() > length && rest_.starts_with(word)) length = word.size();
        }
        return take(length);
    }

    static std::vector<std::string> names_in(const Json& list) {
        std::vector<std::string> names;
        for (const Json& element : list)
            names.push_back(element.is_object() ? element.value("name", "") : "");
        return names;
    }

    std::string take(size_t length) {
        std::string part(rest_.substr(0, length));
        if (part.empty())
            fail(path_, "the path has an empty part", "for example render.max_depth=8");
        rest_.remove_prefix(length);
        return part;
    }

    size_t index_of(const std::string& word, const Json& list) const {
        size_t index = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
        if (error == std::errc() && end == word.data() + word.size() && index < list.size())
            return index;
        const std::vector<std::string> names = names_in(list);
        if (const auto named = std::find(names.begin(), names.end(), word); named != names.end())
            return static_cast<size_t>(named - names.begin());
        const std::string nearest = nearest_name(word, names);
        fail(path_, fmt::format("there is no element \"{}\"", word),
             !nearest.empty() ? fmt::format("did you mean \"{}\"?", nearest)
             : list.empty()   ? std::string("the list is empty")
                            : fmt::format("the list has {} element{}, numbered from 0", list.size(),
                                          list.size() == 1 ? "" : "s"));
    }

    std::string_view path_, rest_;
};

// The value that the path leads to; a last key that is not there yet is made.
Json& place_of(Json& json, std::string_view path) {
    PathReader parts(path);
    Json* place = &json;
    do {
        if (place->is_array())
            place = &(*place)[parts.next_index(*place)];
        else if (place->is_object() || place->is_null())
            place = &(*place)[parts.next_key(*place)];
        else
            fail(path, "the path goes on behind a plain value", "leave out what follows it");
    } while (!parts.at_end());
    return *place;
}

// "camera" is the active one of several, and "cameras" a list of one.
void alias_cameras(Json& json, const Scene& scene, std::string& path) {
    const auto starts_with_key = [&](std::string_view key) {
        return path.starts_with(key) &&
               (path.size() == key.size() || path[key.size()] == '.' || path[key.size()] == '[');
    };
    if (starts_with_key("cameras") && json.contains("camera")) {
        json["cameras"] = Json::array({json["camera"]});
        json.erase("camera");
    } else if (starts_with_key("camera") && json.contains("cameras")) {
        size_t active = 0;
        for (size_t i = 0; i < scene.cameras.size(); ++i)
            if (scene.cameras[i].id == scene.active_camera) active = i;
        path.replace(0, 6, fmt::format("cameras[{}]", active));
    }
}

// Settings that no object, material or texture has a part in: those stay out of the way, which
// keeps their ids, and is quick in a scene of a million.
bool is_setting_alone(std::string_view path) {
    const std::string_view head = path.substr(0, path.find_first_of(".["));
    constexpr std::array<std::string_view, 8> kAlone = {"name",       "description",  "camera",
                                                        "cameras",    "render",       "display",
                                                        "background", "active_camera"};
    return std::find(kAlone.begin(), kAlone.end(), head) != kAlone.end();
}

bool is_number_out_of_range(std::string_view text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc::result_out_of_range && end == text.data() + text.size();
}

Scene without_things(Scene scene) {
    scene.objects = {};
    scene.generators = {};
    scene.materials = {};
    scene.textures = {};
    scene.models = {};
    return scene;
}

}  // namespace

Scene with_setting(const Scene& scene, std::string_view path, std::string_view value) {
    // A value is JSON; a bare word is a string.
    Json parsed = Json::parse(value, nullptr, false);
    if (parsed.is_discarded()) {
        if (is_number_out_of_range(value))
            fail(path, fmt::format("{} is too large", value), "numbers stay below 1e15");
        parsed = std::string(value);
    }

    const bool alone = is_setting_alone(path);
    Json json = json_of_scene(alone ? without_things(scene) : scene, true);
    std::string full_path(path);
    alias_cameras(json, scene, full_path);
    place_of(json, full_path) = std::move(parsed);
    const std::string name = fmt::format("--set {}", path);
    try {
        ModelCache models(scene.origin.folder, name, &scene);
        Scene changed = scene_of_json(json, name, models);
        changed.origin = scene.origin;
        if (alone) {
            changed.objects = scene.objects;
            changed.generators = scene.generators;
            changed.materials = scene.materials;
            changed.textures = scene.textures;
            changed.models = scene.models;
        }
        check_problems(changed, name, false);
        load_images(changed, name, models, &scene);
        load_meshes(changed, name, models, &scene);
        return changed;
    } catch (const Error& error) {
        // The place need not be said twice.
        std::string what = error.what();
        const std::string twice = fmt::format("{}: {}: ", name, full_path);
        if (what.starts_with(twice)) what.erase(name.size(), twice.size() - 2 - name.size());
        throw Error(ErrorKind::Usage, what);
    }
}

}  // namespace tp
