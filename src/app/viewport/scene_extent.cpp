#include "scene_extent.h"

#include <algorithm>

namespace tp {
namespace {

constexpr double kGroundFactor = 5;
constexpr double kSecondsAcross = 4;

struct Box {
    Double3 low{1e300}, high{-1e300};

    void add(const Extent& e) {
        low = glm::min(low, e.center - e.radius);
        high = glm::max(high, e.center + e.radius);
    }
    Extent extent() const { return {(low + high) * 0.5, glm::distance(low, high) / 2}; }
};

}  // namespace

std::optional<Extent> extent_of(const std::vector<const Object*>& objects) {
    if (objects.empty()) return std::nullopt;
    if (objects.size() == 1) return extent_of(*objects.front());
    Box box;
    for (const Object* o : objects)
        box.add(extent_of(*o));
    return box.extent();
}

std::vector<const Object*> selected_objects(const Scene& scene,
                                            const std::vector<ObjectId>& selection) {
    std::vector<const Object*> objects;
    if (selection.size() == 1) {
        if (const Object* o = find(scene, selection.front())) objects.push_back(o);
        return objects;
    }
    std::vector<uint32_t> ids;
    for (const ObjectId id : selection)
        ids.push_back(id.value);
    std::sort(ids.begin(), ids.end());
    for (const Object& o : scene.objects)
        if (std::binary_search(ids.begin(), ids.end(), o.id.value)) objects.push_back(&o);
    return objects;
}

std::optional<Extent> extent_of_all(const Scene& scene) {
    Scene expanded;
    if (!scene.generators.empty()) expanded = expand_generators(scene);
    std::vector<Extent> extents;
    for (const Object& o : (scene.generators.empty() ? scene : expanded).objects)
        if (o.visible) extents.push_back(extent_of(o));
    if (extents.empty()) return std::nullopt;
    std::sort(extents.begin(), extents.end(),
              [](const Extent& a, const Extent& b) { return a.radius < b.radius; });
    Box box;
    box.add(extents.front());
    for (size_t i = 1; i < extents.size(); ++i) {
        const bool is_far_larger = extents[i].radius > kGroundFactor * box.extent().radius;
        if (is_far_larger && extents.size() - i <= i) break;
        box.add(extents[i]);
    }
    return box.extent();
}

double natural_speed(const Scene& scene) {
    const Camera camera = active_camera(scene);
    const std::optional<Extent> extent = extent_of_all(scene);
    const double size =
        (extent ? extent->radius : 0) + glm::distance(camera.look_from, camera.look_at);
    return std::clamp(size / kSecondsAcross, 1e-4, 1e6);
}

}  // namespace tp
