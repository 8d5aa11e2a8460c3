// Models in scene files: their entries, and what was changed of their things, both ways.
#include "scene_fields.h"
#include "scene_reader.h"
#include "scene_writer.h"

#include <teapath/core/error.h>
#include <teapath/core/log.h>

#include <fmt/format.h>

#include <unordered_map>

namespace tp {
namespace {

constexpr const char* kSections[] = {"objects", "materials", "textures"};

// Things of materials and textures carry their name beside their fields.
template <class Thing>
constexpr bool kHasName = !std::is_same_v<Thing, Object>;

template <class V>
void fields_of(V& v, Object& object) {
    object_fields(v, object);
}
template <class V>
void fields_of(V& v, Material& material) {
    material_fields(v, material);
}
template <class V>
void fields_of(V& v, Texture& texture) {
    texture_fields(v, texture);
}

// The names that the changes give to things of one section, by path.
std::map<std::string, std::string> names_in(const Json& entry, const char* section) {
    std::map<std::string, std::string> names;
    const auto changes = entry.find(section);
    if (changes == entry.end() || !changes->is_object()) return names;
    for (const auto& [path, change] : changes->items())
        if (change.is_object() && change.contains("name") && change["name"].is_string())
            names[path] = change["name"].get<std::string>();
    return names;
}

// Gives the things of a model their names, and makes these known.
template <class Thing, class Id>
void register_names(SharedList<Thing>& list, ModelId model, const Json& entry, const char* section,
                    std::map<std::string, Id>& known) {
    const std::map<std::string, std::string> given = names_in(entry, section);
    if (!given.empty())
        for (Thing& thing : list.edit())
            if (const auto name = given.find(thing.part.path);
                thing.part.model == model && name != given.end())
                thing.name = name->second;
    for (const Thing& thing : list)
        if (thing.part.model == model) known[thing.name] = thing.id;
}

}  // namespace

Material SceneReader::with_name_of(const Material& named, Material value) {
    value.id = named.id;
    value.name = named.name;
    value.part = named.part;
    return value;
}

void SceneReader::models(const char* key, Scene& scene) {
    const Json* list = find(key);
    if (!list) return;
    expect_array(*list, key);
    for (size_t i = 0; i < list->size(); ++i) {
        const Json& entry = (*list)[i];
        const std::string path = fmt::format("{}[{}]", key, i);
        SceneReader inner(state_, entry, path);
        Model model;
        model_fields(inner, model);
        inner.finish();
        if (state_.load_model) model.content = state_.load_model(model.path);
        if (!model.content) {
            state_.model_is_missing = true;
            Json kept = Json::object();
            for (const char* section : kSections)
                if (entry.contains(section)) kept[section] = entry[section];
            if (!kept.empty()) model.kept_changes = kept.dump();
        }
        const bool is_there = model.content != nullptr;
        const ModelId id = add_model(scene, std::move(model));
        if (!is_there) continue;
        register_names(scene.textures, id, entry, "textures", state_.texture_names);
        register_names(scene.materials, id, entry, "materials", state_.material_names);
        state_.model_changes.push_back({id, &entry, path});
    }
}

template <class List, class Read>
void SceneReader::read_changes(const ModelChanges& changes, const char* key, List& list,
                               const Read& read) {
    const auto section = changes.json->find(key);
    if (section == changes.json->end()) return;
    const std::string where = changes.path + "." + key;
    if (!section->is_object())
        fail(where, "expected an object of changes by the name of the part in the model");
    std::unordered_map<std::string, size_t> index;
    for (size_t i = 0; i < list.size(); ++i)
        if (list[i].part.model == changes.model) index[list[i].part.path] = i;
    std::vector<size_t> deleted;
    for (const auto& [path, change] : section->items()) {
        const auto found = index.find(path);
        if (found == index.end()) {
            log_warning("{}: {}: the model has no part \"{}\"; its changes are kept", state_.file,
                        where, path);
            Model& model = state_.scene.models.edit()[changes.model.value - 1];
            Json kept =
                model.kept_changes.empty() ? Json::object() : Json::parse(model.kept_changes);
            kept[key][path] = change;
            model.kept_changes = kept.dump();
        } else if (change.is_null()) {
            deleted.push_back(found->second);
        } else {
            // Reading may add to the list: the thing is put back by its position.
            auto thing = list[found->second];
            SceneReader inner(state_, change, where + "." + path, true);
            read(inner, thing);
            inner.finish();
            list.edit()[found->second] = std::move(thing);
        }
    }
    std::sort(deleted.rbegin(), deleted.rend());
    for (const size_t i : deleted)
        list.edit().erase(list.edit().begin() + static_cast<std::ptrdiff_t>(i));
}

void SceneReader::model_changes() {
    Scene& scene = state_.scene;
    const auto read = [](SceneReader& inner, auto& thing) {
        if constexpr (kHasName<std::remove_cvref_t<decltype(thing)>>) inner("name", thing.name);
        fields_of(inner, thing);
    };
    for (const ModelChanges& changes : state_.model_changes) {
        read_changes(changes, "textures", scene.textures, read);
        read_changes(changes, "materials", scene.materials, read);
        read_changes(changes, "objects", scene.objects, read);
    }
}

namespace {

// What `now` says otherwise than `before`, for a reader of changes.
Json change_of(Json now, const Json& before) {
    Json change = Json::object();
    for (auto& [key, value] : now.items()) {
        const auto old = before.find(key);
        if (old == before.end() || *old != value) change[key] = std::move(value);
    }
    for (const auto& [key, value] : before.items())
        if (!now.contains(key)) change[key] = nullptr;
    return change;
}

}  // namespace

template <class Thing>
Json SceneWriter::changes_of(const Model& model, const std::vector<Thing>& things,
                             std::vector<Thing> before) const {
    std::unordered_map<std::string, const Thing*> now;
    for (const Thing& thing : things)
        if (thing.part.model == model.id) now[thing.part.path] = &thing;
    Json changes = Json::object();
    for (Thing& old : before) {
        const auto found = now.find(old.part.path);
        if (found == now.end()) {
            changes[old.part.path] = nullptr;
            continue;
        }
        Thing thing = *found->second;
        old.id = thing.id;
        Json change = Json::object();
        if constexpr (kHasName<Thing>) {
            const std::string& name = name_of(thing.id);
            if (name != old.name) change["name"] = name;
            old.name = thing.name;
        }
        if (!(thing == old)) {
            bool is_whole = false;  // another kind of thing: all of it is written
            if constexpr (kHasName<Thing>) is_whole = thing.kind != old.kind;
            SceneWriter mine(state_), theirs(state_);
            fields_of(mine, thing);
            fields_of(theirs, old);
            Json rest = is_whole ? difference(thing, [](auto& v, Thing& t) { fields_of(v, t); })
                                 : change_of(mine.take(), theirs.take());
            change.update(rest);
        }
        if (!change.empty()) changes[old.part.path] = std::move(change);
    }
    return changes;
}

void SceneWriter::models(const char* key, const Scene& scene) {
    if (scene.models.empty()) return;
    Json list = Json::array();
    for (Model model : scene.models) {
        Json entry = difference(model, [](auto& v, Model& m) { model_fields(v, m); });
        if (!model.kept_changes.empty()) entry.update(Json::parse(model.kept_changes));
        if (model.content) {
            ModelThings before = things_of(model, ids_of(scene, model.id));
            const Json changes[] = {
                changes_of(model, scene.objects.items(), std::move(before.objects)),
                changes_of(model, scene.materials.items(), std::move(before.materials)),
                changes_of(model, scene.textures.items(), std::move(before.textures))};
            for (size_t i = 0; i < 3; ++i)
                for (const auto& [path, change] : changes[i].items())
                    entry[kSections[i]][path] = change;
        }
        list.push_back(std::move(entry));
    }
    json_[key] = std::move(list);
}

}  // namespace tp
