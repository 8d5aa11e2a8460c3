#include "place_in_view.h"

#include <teapath/device/pick.h>

namespace tp {
namespace {

constexpr int64_t kMostObjects = 50'000;  // a tree over more would hold up the frame
constexpr double kFarthest = 3;           // times the distance of what is looked at

int64_t object_count(const Scene& scene) {
    auto count = static_cast<int64_t>(scene.objects.size());
    for (const Generator& g : scene.generators)
        count += int64_t{g.grid.columns} * g.grid.rows;
    return count;
}

}  // namespace

Place place_in_view(const Scene& scene) {
    const Camera camera = active_camera(scene);
    const double looked = glm::distance(camera.look_from, camera.look_at);
    const Place in_air{camera.look_at, false, looked};
    if (object_count(scene) > kMostObjects) return in_air;
    // Geometry alone: a copy without materials and images.
    Scene shapes;
    shapes.cameras = {camera};
    shapes.objects = scene.objects;
    for (Object& o : shapes.objects.edit())
        o.material = {};
    shapes.generators = scene.generators;
    SceneArrays arrays;
    flatten(shapes, SceneParts::All, arrays);
    const Double3 view = (camera.look_at - camera.look_from) / looked;
    const PickResult hit = pick(arrays, camera.look_from, view, kFarthest * looked);
    if (!hit.object) return in_air;
    return {hit.point, true, glm::distance(camera.look_from, hit.point)};
}

}  // namespace tp
