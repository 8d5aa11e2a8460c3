#include "scene_things.h"

#include <teapath/editor/model_edits.h>
#include <teapath/editor/refusal.h>
#include <teapath/scene/texture_uses.h>

#include <unordered_map>
#include <unordered_set>

namespace tp {
namespace {

// Lets go of the model's things in the list: those in use stay as the scene's own.
template <class List>
void release(List& list, ModelId model, const std::unordered_set<uint32_t>& used) {
    auto& items = list.edit();
    std::erase_if(items, [&](const auto& thing) {
        return thing.part.model == model && !used.count(thing.id.value);
    });
    for (auto& thing : items)
        if (thing.part.model == model) thing.part = {};
}

DoubleMat3 placement_of(const Object& object) {
    const auto* mesh = std::get_if<MeshShape>(&object.shape);
    return mesh ? mesh->placement : DoubleMat3(1);
}

bool stands_as(const Object& a, const Object& b) {
    return a.transform == b.transform && placement_of(a) == placement_of(b);
}

void stand_as(Object& a, const Object& b) {
    a.transform = b.transform;
    if (auto* mesh = std::get_if<MeshShape>(&a.shape)) mesh->placement = placement_of(b);
}

}  // namespace

const Model* find(const Scene& scene, ModelId id) {
    for (const Model& model : scene.models)
        if (id && model.id == id) return &model;
    return nullptr;
}

std::vector<ObjectId> objects_of(const Scene& scene, ModelId id) {
    std::vector<ObjectId> ids;
    for (const Object& object : scene.objects)
        if (id && object.part.model == id) ids.push_back(object.id);
    return ids;
}

void place_model(Scene& scene, ModelId id, const Transform& transform) {
    Model* model = find_in(scene.models.edit(), id);
    if (!model || model->transform == transform) return;
    const DoubleMat4 change =
        world_from_object(transform) * glm::inverse(world_from_object(model->transform));
    // Where an object stands as its file has it, it does so after the change too, to the last bit:
    // else it would count as one that was moved.
    const ModelIds no_ids;
    const ModelThings before = things_of(*model, no_ids);
    model->transform = transform;
    const ModelThings after = things_of(*model, no_ids);
    std::unordered_map<std::string, size_t> index;
    for (size_t i = 0; i < before.objects.size(); ++i)
        index[before.objects[i].part.path] = i;
    for (Object& object : scene.objects.edit()) {
        if (object.part.model != id) continue;
        const auto found = index.find(object.part.path);
        if (found != index.end() && stands_as(object, before.objects[found->second]))
            stand_as(object, after.objects[found->second]);
        else
            move_object(object, change);
    }
}

std::string refusal_of_place(const Scene& scene, ModelId id, const Transform& transform) {
    for (int axis = 0; axis < 3; ++axis)
        if (transform.scale[axis] == 0) return "a scale is 0";
    Scene placed = scene;
    place_model(placed, id, transform);
    std::vector<Object> objects;
    for (const Object& object : placed.objects)
        if (object.part.model == id) objects.push_back(object);
    return refusal(objects);
}

void delete_model(Scene& scene, ModelId id) {
    if (!find(scene, id)) return;
    std::erase_if(scene.objects.edit(), [id](const Object& o) { return o.part.model == id; });
    std::unordered_set<uint32_t> materials, textures;
    for (const Object& object : scene.objects)
        materials.insert(object.material.value);
    release(scene.materials, id, materials);
    const auto use = [&](const char*, const auto& slot) {
        textures.insert(texture_in(slot).value);
    };
    for (const Material& material : scene.materials)
        for_each_slot(material, use);
    for (const Texture& texture : scene.textures)
        for_each_slot(texture, use);
    release(scene.textures, id, textures);
    std::erase_if(scene.models.edit(), [id](const Model& m) { return m.id == id; });
}

ModelId duplicate_model(Scene& scene, ModelId id) {
    const Model* model = find(scene, id);
    if (!model) return {};
    Model copy = *model;
    copy.name = free_name(scene.models, copy.name.empty() ? "model" : copy.name);
    return add_model(scene, std::move(copy));
}

}  // namespace tp
