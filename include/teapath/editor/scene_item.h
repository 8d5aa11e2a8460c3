// Anything of a scene that has a row in the tree and can be selected: one small value for all
// kinds.
#pragma once

#include <teapath/scene/scene.h>

#include <compare>
#include <string>
#include <vector>

namespace tp {

enum class ItemKind : uint8_t { Object, Generator, Camera, Material, Texture, Background, Model };

struct SceneItem {
    ItemKind kind = ItemKind::Object;
    uint32_t id = 0;  // the value of its ObjectId, CameraId …; 0 for the background

    friend auto operator<=>(const SceneItem&, const SceneItem&) = default;
};

inline SceneItem item_of(ObjectId id) {
    return {ItemKind::Object, id.value};
}
inline SceneItem item_of(GeneratorId id) {
    return {ItemKind::Generator, id.value};
}
inline SceneItem item_of(CameraId id) {
    return {ItemKind::Camera, id.value};
}
inline SceneItem item_of(MaterialId id) {
    return {ItemKind::Material, id.value};
}
inline SceneItem item_of(TextureId id) {
    return {ItemKind::Texture, id.value};
}
inline SceneItem item_of(ModelId id) {
    return {ItemKind::Model, id.value};
}
inline SceneItem background_item() {
    return {ItemKind::Background, 0};
}

bool exists(const Scene& scene, SceneItem item);

/// Its name, or what it is called where it has none.
std::string item_name(const Scene& scene, SceneItem item);

/// Gives it that name, with a number where another of its kind has it already (objects may share
/// one). The background has none.
void rename_item(Scene& scene, SceneItem item, const std::string& name);

/// Copies them; returns the new ones. Objects stand a little to the side.
std::vector<SceneItem> duplicate_items(Scene& scene, const std::vector<SceneItem>& items);

/// Removes them, and every use of them. The last camera and the background stay.
void delete_items(Scene& scene, const std::vector<SceneItem>& items);

/// Why `delete_items` would leave this one alone; empty if it would not.
std::string why_not_deleted(const Scene& scene, SceneItem item);

}  // namespace tp
