#include <teapath/scene/model.h>
#include <teapath/scene/scene.h>
#include <teapath/scene/texture_uses.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <unordered_map>

namespace tp {
namespace {

template <class Things>
uint32_t highest_id(const Things& things) {
    uint32_t highest = 0;
    for (const auto& thing : things)
        highest = std::max(highest, thing.id.value);
    return highest;
}

// Gives each thing without a name, or with one that is taken, another.
template <class Things>
void name_apart(std::vector<Things>& added, const std::vector<Things>& present, const char* word) {
    std::set<std::string> taken;
    for (const auto& thing : present)
        taken.insert(thing.name);
    std::unordered_map<std::string, int> numbers;
    for (auto& thing : added) {
        const std::string stem = thing.name.empty() ? word : thing.name;
        std::string name = stem;
        for (int& n = numbers.try_emplace(stem, 1).first->second; !taken.insert(name).second;)
            name = fmt::format("{} {}", stem, ++n);
        thing.name = std::move(name);
    }
}

// A path of the model's file as one of the scene's.
void lead_from(const Model& model, std::string& path) {
    const std::filesystem::path folder = std::filesystem::path(model.path).parent_path();
    if (!folder.empty() && !path.empty()) path = (folder / path).generic_string();
}

}  // namespace

void move_object(Object& object, const DoubleMat4& change) {
    auto* mesh = std::get_if<MeshShape>(&object.shape);
    const DoubleMat3 own = mesh ? mesh->placement : DoubleMat3(1);
    const auto split =
        split_transform(change * world_from_object(object.transform) * DoubleMat4(own));
    if (!split) return;  // it would be flat
    object.transform = split->transform;
    if (mesh) mesh->placement = split->placement;
}

ModelThings things_of(const Model& model, const ModelIds& ids) {
    ModelThings things;
    if (!model.content) return things;
    const ModelContent& content = *model.content;
    things = {content.objects, content.materials, content.textures};

    // From ids of the content to those of the scene.
    std::unordered_map<uint32_t, TextureId> textures;
    std::unordered_map<uint32_t, MaterialId> materials;
    const auto take = [&](auto& thing, const auto& known, auto& map) {
        const auto found = known.find(thing.part.path);
        const auto old = thing.id.value;
        thing.part.model = model.id;
        thing.id = found == known.end() ? decltype(thing.id){} : found->second;
        map[old] = thing.id;
    };
    for (Texture& texture : things.textures) {
        take(texture, ids.textures, textures);
        lead_from(model, texture.file.path);
    }
    for (Material& material : things.materials)
        take(material, ids.materials, materials);
    const auto rewire = [&](const char*, auto& slot) {
        if (TextureId& id = texture_in(slot)) id = textures[id.value];
    };
    for (Texture& texture : things.textures)
        for_each_slot(texture, rewire);
    for (Material& material : things.materials)
        for_each_slot(material, rewire);

    const bool moves = !(model.transform == Transform{});
    const DoubleMat4 under = world_from_object(model.transform);
    for (Object& object : things.objects) {
        object.id = {};
        object.part.model = model.id;
        if (object.material) object.material = materials[object.material.value];
        if (auto* shape = std::get_if<MeshShape>(&object.shape)) lead_from(model, shape->file.path);
        if (moves) move_object(object, under);
    }
    return things;
}

ModelIds ids_of(const Scene& scene, ModelId model) {
    ModelIds ids;
    for (const Material& m : scene.materials)
        if (m.part.model == model) ids.materials[m.part.path] = m.id;
    for (const Texture& t : scene.textures)
        if (t.part.model == model) ids.textures[t.part.path] = t.id;
    return ids;
}

ModelId add_model(Scene& scene, Model model) {
    model.id = {highest_id(scene.models) + 1};
    ModelIds ids;
    if (model.content) {
        uint32_t material = highest_id(scene.materials), texture = highest_id(scene.textures);
        for (const Material& m : model.content->materials)
            ids.materials[m.part.path] = {++material};
        for (const Texture& t : model.content->textures)
            ids.textures[t.part.path] = {++texture};
    }
    ModelThings things = things_of(model, ids);
    uint32_t object = highest_id(scene.objects);
    for (Object& o : things.objects)
        o.id = {++object};
    name_apart(things.materials, scene.materials.items(), "material");
    name_apart(things.textures, scene.textures.items(), "texture");
    const auto append = [](auto& list, auto& more) {
        if (more.empty()) return;
        auto& items = list.edit();
        items.insert(items.end(), std::make_move_iterator(more.begin()),
                     std::make_move_iterator(more.end()));
    };
    append(scene.objects, things.objects);
    append(scene.materials, things.materials);
    append(scene.textures, things.textures);
    const ModelId id = model.id;
    scene.models.edit().push_back(std::move(model));
    return id;
}

}  // namespace tp
