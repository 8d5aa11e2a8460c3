#include "scene_things.h"

#include <teapath/editor/model_edits.h>
#include <teapath/editor/scene_edits.h>
#include <teapath/editor/scene_item.h>
#include <teapath/scene/texture_uses.h>

namespace tp {
namespace {

// Calls `f` with the vector that holds things of that kind.
template <class AnyScene, class F>
auto with_things(AnyScene& scene, ItemKind kind, const F& f) {
    switch (kind) {
        case ItemKind::Generator: return f(elements(scene.generators));
        case ItemKind::Camera: return f(scene.cameras);
        case ItemKind::Material: return f(elements(scene.materials));
        case ItemKind::Texture: return f(elements(scene.textures));
        case ItemKind::Model: return f(elements(scene.models));
        case ItemKind::Object:
        case ItemKind::Background: break;
    }
    return f(elements(scene.objects));
}

template <class Things>
auto position_of(Things& things, uint32_t id) {
    return std::find_if(things.begin(), things.end(),
                        [id](const auto& thing) { return thing.id.value == id; });
}

const char* kind_name(ItemKind kind) {
    switch (kind) {
        case ItemKind::Object: return "object";
        case ItemKind::Generator: return "sphere grid";
        case ItemKind::Camera: return "camera";
        case ItemKind::Material: return "material";
        case ItemKind::Texture: return "texture";
        case ItemKind::Model: return "model";
        case ItemKind::Background: break;
    }
    return "Background";
}

void forget_material(Scene& scene, MaterialId id) {
    for (Object& o : scene.objects.edit())
        if (o.material == id) o.material = {};
}

void forget_texture(Scene& scene, TextureId id) {
    const auto forget = [id](const char*, auto& slot) {
        if (texture_in(slot) == id) texture_in(slot) = {};
    };
    for (Material& m : scene.materials.edit())
        for_each_slot(m, forget);
    for (Texture& t : scene.textures.edit())
        for_each_slot(t, forget);
}

void delete_item(Scene& scene, SceneItem item) {
    if (!why_not_deleted(scene, item).empty()) return;
    if (item.kind == ItemKind::Model) return delete_model(scene, {item.id});
    with_things(scene, item.kind, [&](auto& things) {
        std::erase_if(things, [&](const auto& thing) { return thing.id.value == item.id; });
    });
    if (item.kind == ItemKind::Material) forget_material(scene, {item.id});
    if (item.kind == ItemKind::Texture) forget_texture(scene, {item.id});
    if (item.kind == ItemKind::Camera && scene.active_camera.value == item.id)
        scene.active_camera = {};
}

}  // namespace

bool exists(const Scene& scene, SceneItem item) {
    if (item.kind == ItemKind::Background) return true;
    return item.id != 0 && with_things(scene, item.kind, [&](const auto& things) {
               return position_of(things, item.id) != things.end();
           });
}

std::string item_name(const Scene& scene, SceneItem item) {
    if (item.kind == ItemKind::Background) return "Background";
    if (item.kind == ItemKind::Object) {
        const Object* object = find(scene, ObjectId{item.id});
        return object ? display_name(*object) : std::string();
    }
    return with_things(scene, item.kind, [&](const auto& things) -> std::string {
        const auto found = position_of(things, item.id);
        if (found == things.end()) return {};
        if (!found->name.empty()) return found->name;
        // One camera needs no number.
        if (item.kind == ItemKind::Camera && things.size() == 1) return "camera";
        return fmt::format("{} {}", kind_name(item.kind), item.id);
    });
}

void rename_item(Scene& scene, SceneItem item, const std::string& name) {
    if (item.kind == ItemKind::Background) return;
    with_things(scene, item.kind, [&](auto& things) {
        const auto found = position_of(things, item.id);
        if (found == things.end()) return;
        const bool may_be_shared = item.kind == ItemKind::Object || name.empty();
        found->name = may_be_shared ? name : free_name(things, name, &*found);
    });
}

std::vector<SceneItem> duplicate_items(Scene& scene, const std::vector<SceneItem>& items) {
    std::vector<SceneItem> made;
    std::vector<ObjectId> objects;
    for (const SceneItem item : items) {
        if (item.kind == ItemKind::Background) continue;
        if (item.kind == ItemKind::Object) {
            objects.push_back({item.id});
            continue;
        }
        if (item.kind == ItemKind::Model) {
            if (const ModelId id = duplicate_model(scene, {item.id})) made.push_back(item_of(id));
            continue;
        }
        with_things(scene, item.kind, [&](auto& things) {
            const auto found = position_of(things, item.id);
            if (found == things.end()) return;
            auto copy = *found;
            if constexpr (requires { copy.part; }) copy.part = {};  // a thing of the scene's own
            copy.id = next_id(things);
            if (copy.name.empty()) copy.name = kind_name(item.kind);
            copy.name = free_name(things, copy.name);
            made.push_back({item.kind, copy.id.value});
            things.push_back(std::move(copy));
        });
    }
    for (const ObjectId id : duplicate_objects(scene, objects))
        made.push_back(item_of(id));
    return made;
}

void delete_items(Scene& scene, const std::vector<SceneItem>& items) {
    std::vector<ObjectId> objects;
    for (const SceneItem item : items) {
        if (item.kind == ItemKind::Object)
            objects.push_back({item.id});
        else
            delete_item(scene, item);
    }
    delete_objects(scene, objects);
}

std::string why_not_deleted(const Scene& scene, SceneItem item) {
    if (item.kind == ItemKind::Background) return "Every scene has a background";
    if (item.kind == ItemKind::Camera && scene.cameras.size() <= 1)
        return "The last camera stays: a scene is seen through one";
    return {};
}

}  // namespace tp
