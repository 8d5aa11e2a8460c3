#include "scene_extent.h"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double kGroundFactor = 5;
constexpr double kSecondsAcross = 4;

struct Box {
    Double3 low{1e300}, high{-1e300};

    void add(const Box& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    void add(const Extent& e) { add(Box{e.center - e.radius, e.center + e.radius}); }
    Extent extent() const { return {(low + high) * 0.5, glm::distance(low, high) / 2}; }
};

// Objects of one size: one of the document's, or all of a generator's, which are never made here.
struct Group {
    Box box;
    double radius;  // of each object
    size_t count;
};

Group group_of(const Object& object) {
    const Extent extent = extent_of(object);
    Group group{{}, extent.radius, 1};
    group.box.add(extent);
    return group;
}

Group group_of(const SphereGrid& grid) {
    const GridBox centers = box_of_centers(grid);
    // A sphere's surroundings are those of its box, as for an object.
    const double radius = std::max(std::abs(grid.radius) * std::sqrt(3.0), 1e-6);
    return {{centers.low - radius, centers.high + radius},
            radius,
            static_cast<size_t>(grid.columns) * static_cast<size_t>(grid.rows)};
}

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
    std::vector<Group> groups;
    size_t larger = 0;  // objects in the groups to come
    const auto add = [&](const Group& group) {
        groups.push_back(group);
        larger += group.count;
    };
    for (const Object& o : scene.objects)
        if (o.visible) add(group_of(o));
    for (const Generator& g : scene.generators)
        if (g.grid.columns > 0 && g.grid.rows > 0) add(group_of(g.grid));
    if (groups.empty()) return std::nullopt;
    std::sort(groups.begin(), groups.end(),
              [](const Group& a, const Group& b) { return a.radius < b.radius; });
    Box box;
    size_t smaller = 0;
    for (const Group& group : groups) {
        const bool is_far_larger =
            smaller > 0 && group.radius > kGroundFactor * box.extent().radius;
        if (is_far_larger && larger <= smaller) break;
        box.add(group.box);
        smaller += group.count;
        larger -= group.count;
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
