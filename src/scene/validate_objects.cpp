// Checks of objects: placement, material, and a shape that has a size.
#include "problem_list.h"

#include <unordered_set>

namespace tp {
namespace {

class ShapeChecker {
public:
    ShapeChecker(const Place& where, ProblemList& problems) : where_(where), problems_(problems) {}

    void operator()(const SphereShape& s) const {
        finite("center", s.center);
        if (finite("radius", s.radius))
            size(where_ / "radius", s.radius, "the sphere has radius 0");
    }
    void operator()(const XyRectShape& r) const { axis_rect(r); }
    void operator()(const XzRectShape& r) const { axis_rect(r); }
    void operator()(const YzRectShape& r) const { axis_rect(r); }
    void operator()(const RectangleShape& r) const {
        if (finite("corner", r.corner) && finite("edge_u", r.edge_u) && finite("edge_v", r.edge_v))
            area(r.edge_u, r.edge_v, "the rectangle has no area");
    }
    void operator()(const BoxShape& b) const {
        if (!finite("low", b.low) || !finite("high", b.high)) return;
        if (b.low.x > b.high.x || b.low.y > b.high.y || b.low.z > b.high.z)
            problems_.fatal(where_ / "low", "the low corner is above the high one", "swap them");
        else
            for (int axis = 0; axis < 3; ++axis)
                if (!size(where_, b.high[axis] - b.low[axis], "the box has no volume")) break;
    }
    void operator()(const DiskShape& d) const {
        finite("center", d.center);
        if (finite("normal", d.normal) && !(glm::length(d.normal) >= ProblemList::kSmallest))
            problems_.fatal(where_ / "normal", "the normal has no direction",
                            "for a disk on the floor take [0, 1, 0]");
        if (problems_.not_negative(where_ / "radius", d.radius, "radius",
                                   "a normal turned round shows the other side"))
            size(where_ / "radius", d.radius, "the disk has radius 0");
    }
    void operator()(const TriangleShape& t) const {
        if (finite("a", t.a) && finite("b", t.b) && finite("c", t.c))
            area(t.b - t.a, t.c - t.a, "the triangle has no area");
    }

private:
    template <class T>
    bool finite(const char* key, const T& value) const {
        return problems_.finite(where_ / key, value);
    }

    // A length; 0 is a warning, and too little for the kernels' numbers an error.
    bool size(const Place& where, double length, const char* if_zero) const {
        if (length == 0)
            problems_.warn(where, fmt::format("{}: it is never hit", if_zero));
        else if (std::abs(length) < ProblemList::kSmallest)
            problems_.fatal(where, fmt::format("a size of {} is too small", length),
                            "sizes are 1e-15 or more");
        else
            return true;
        return false;
    }

    void area(const Double3& u, const Double3& v, const char* if_zero) const {
        const double lengths = glm::length(u) * glm::length(v);
        if (!(glm::length(glm::cross(u, v)) > 0))
            problems_.warn(where_, fmt::format("{}: it is never hit", if_zero));
        else if (lengths < ProblemList::kSmallest * ProblemList::kSmallest)
            problems_.fatal(where_, "its sides are too short", "sizes are 1e-15 or more");
    }

    template <class Rect>
    void axis_rect(const Rect& r) const {
        if (!finite("low", r.low) || !finite("high", r.high) || !finite("k", r.k)) return;
        if (r.low.x > r.high.x || r.low.y > r.high.y)
            problems_.fatal(where_ / "low", "the low corner is above the high one",
                            "swap them; \"inside_out\": true turns the front round");
        else
            for (int axis = 0; axis < 2; ++axis)
                if (!size(where_, r.high[axis] - r.low[axis], "the rectangle has no area")) break;
    }

    const Place& where_;
    ProblemList& problems_;
};

void check_transform(const Transform& t, const Place& where, ProblemList& problems) {
    problems.finite(where / "translate", t.translation);
    problems.finite(where / "rotate", t.rotation);
    if (!problems.finite(where / "scale", t.scale)) return;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(t.scale[axis]) >= ProblemList::kSmallest) continue;
        problems.fatal(where / "scale",
                       t.scale[axis] == 0
                           ? std::string("a scale of 0 leaves nothing")
                           : fmt::format("a scale of {} is too small", t.scale[axis]),
                       "use \"visible\": false to hide an object");
        return;
    }
}

}  // namespace

void check_objects(const Scene& scene, ProblemList& problems) {
    std::unordered_set<uint32_t> materials;
    for (const Material& m : scene.materials)
        materials.insert(m.id.value);
    const Place list = "objects";
    for (size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const Place where = list[i];
        if (object.material && !materials.count(object.material.value))
            problems.fatal(where / "material", "the material does not exist", "choose another");
        check_transform(object.transform, where / "transform", problems);
        const Place shape = where / "shape";
        std::visit(ShapeChecker(shape, problems), object.shape);
    }
}

}  // namespace tp
