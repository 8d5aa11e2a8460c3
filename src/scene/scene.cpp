#include <teapath/scene/scene.h>

#include <algorithm>

namespace tp {
namespace {

template <class T, class Id>
const T* find_by_id(const std::vector<T>& things, Id id) {
    const auto found =
        std::find_if(things.begin(), things.end(), [id](const T& thing) { return thing.id == id; });
    return id && found != things.end() ? &*found : nullptr;
}

}  // namespace

const Material* find(const Scene& scene, MaterialId id) {
    return find_by_id(scene.materials.items(), id);
}
const Texture* find(const Scene& scene, TextureId id) {
    return find_by_id(scene.textures.items(), id);
}
const Object* find(const Scene& scene, ObjectId id) {
    return find_by_id(scene.objects.items(), id);
}
const Camera* find(const Scene& scene, CameraId id) {
    return find_by_id(scene.cameras, id);
}

Camera active_camera(const Scene& scene) {
    if (const Camera* camera = find(scene, scene.active_camera)) return *camera;
    return scene.cameras.empty() ? Camera{} : scene.cameras.front();
}

double effective_focus_distance(const Camera& camera) {
    return camera.focus_distance > 0 ? camera.focus_distance
                                     : glm::distance(camera.look_from, camera.look_at);
}

}  // namespace tp
