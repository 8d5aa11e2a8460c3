// Checks of objects: placement, material, and a shape that has a size.
#include "problem_list.h"

#include <algorithm>
#include <unordered_set>

namespace tp {
namespace {

class ShapeChecker {
public:
    ShapeChecker(const Place& where, double smallest_scale, ProblemList& problems)
        : where_(where), smallest_scale_(smallest_scale), problems_(problems) {}

    /// After the check: no point of the shape is farther than this from its own origin.
    double reach() const { return reach_; }

    void operator()(const SphereShape& s) {
        finite("center", s.center);
        if (finite("radius", s.radius))
            size(where_ / "radius", s.radius, "the sphere has radius 0");
    }
    void operator()(const XyRectShape& r) { axis_rect(r); }
    void operator()(const XzRectShape& r) { axis_rect(r); }
    void operator()(const YzRectShape& r) { axis_rect(r); }
    void operator()(const RectangleShape& r) {
        if (finite("corner", r.corner) && finite("edge_u", r.edge_u) && finite("edge_v", r.edge_v))
            area(r.edge_u, r.edge_v, "the rectangle has no area");
    }
    void operator()(const BoxShape& b) {
        if (!finite("low", b.low) || !finite("high", b.high)) return;
        if (b.low.x > b.high.x || b.low.y > b.high.y || b.low.z > b.high.z)
            problems_.fatal(where_ / "low", "the low corner is above the high one", "swap them");
        else
            for (int axis = 0; axis < 3; ++axis)
                if (!size(where_, b.high[axis] - b.low[axis], "the box has no volume")) break;
    }
    void operator()(const DiskShape& d) {
        finite("center", d.center);
        if (problems_.finite(where_ / "normal", d.normal) &&
            !(glm::length(d.normal) >= ProblemList::kSmallest))
            problems_.fatal(where_ / "normal", "the normal has no direction",
                            "for a disk on the floor take [0, 1, 0]");
        if (!finite("radius", d.radius)) return;
        if (d.radius < 0)
            problems_.fatal(where_ / "radius", "the radius is negative",
                            "a normal turned round shows the other side");
        else
            size(where_ / "radius", d.radius, "the disk has radius 0");
    }
    void operator()(const TriangleShape& t) {
        if (finite("a", t.a) && finite("b", t.b) && finite("c", t.c))
            area(t.b - t.a, t.c - t.a, "the triangle has no area");
    }

    void operator()(const MeshShape& m) {
        for (int column = 0; column < 3; ++column)
            problems_.finite(where_ / "placement", m.placement[column]);
        if (!m.file.mesh) return;
        const Mesh& mesh = *m.file.mesh;
        const Double3 far = glm::max(glm::abs(Double3(mesh.low)), glm::abs(Double3(mesh.high)));
        for (int axis = 0; axis < 3; ++axis)
            reach_ += glm::length(m.placement[axis]) * far[axis];
        if (glm::determinant(m.placement) == 0)
            problems_.fatal(where_ / "placement", "the placement leaves no volume",
                            "leave it out: it is what a model file does to the mesh");
    }

private:
    bool finite(const char* key, double value) {
        reach_ += std::abs(value);
        return problems_.finite(where_ / key, value);
    }
    template <int kLength>
    bool finite(const char* key, const glm::vec<kLength, double>& value) {
        reach_ += glm::length(value);
        return problems_.finite(where_ / key, value);
    }

    // A length; 0 is a warning, and too little for the kernels' numbers an error.
    bool size(const Place& where, double length, const char* if_zero) const {
        if (length == 0)
            problems_.warn(where, fmt::format("{}: it is never hit", if_zero));
        else if (std::abs(length) * smallest_scale_ < ProblemList::kSmallest)
            problems_.fatal(where, fmt::format("a size of {} is too small", length),
                            "sizes, scaled, are 1e-15 or more");
        else
            return true;
        return false;
    }

    void area(const Double3& u, const Double3& v, const char* if_zero) const {
        const double lengths = glm::length(u) * glm::length(v) * smallest_scale_ * smallest_scale_;
        if (!(glm::length(glm::cross(u, v)) > 0))
            problems_.warn(where_, fmt::format("{}: it is never hit", if_zero));
        else if (lengths < ProblemList::kSmallest * ProblemList::kSmallest)
            problems_.fatal(where_, "its sides are too short", "sizes, scaled, are 1e-15 or more");
    }

    template <class Rect>
    void axis_rect(const Rect& r) {
        if (!finite("low", r.low) || !finite("high", r.high) || !finite("k", r.k)) return;
        if (r.low.x > r.high.x || r.low.y > r.high.y)
            problems_.fatal(where_ / "low", "the low corner is above the high one",
                            "swap them; \"inside_out\": true turns the front round");
        else
            for (int axis = 0; axis < 2; ++axis)
                if (!size(where_, r.high[axis] - r.low[axis], "the rectangle has no area")) break;
    }

    const Place& where_;
    double smallest_scale_;
    double reach_ = 0;
    ProblemList& problems_;
};

// True if there is no problem.
bool check_transform(const Transform& t, const Place& where, ProblemList& problems) {
    const bool finite = problems.finite(where / "translate", t.translation) &&
                        problems.finite(where / "rotate", t.rotation) &&
                        problems.finite(where / "scale", t.scale);
    if (!finite) return false;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(t.scale[axis]) >= ProblemList::kSmallest) continue;
        problems.fatal(where / "scale",
                       t.scale[axis] == 0
                           ? std::string("a scale of 0 leaves nothing")
                           : fmt::format("a scale of {} is too small", t.scale[axis]),
                       "use \"visible\": false to hide an object");
        return false;
    }
    return true;
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
        const bool placed = check_transform(object.transform, where / "transform", problems);
        const Place shape = where / "shape";
        const Double3 scale = placed ? glm::abs(object.transform.scale) : Double3(1);
        ShapeChecker checker(shape, std::min({scale.x, scale.y, scale.z}), problems);
        std::visit(checker, object.shape);
        const double reach = checker.reach() * std::max({scale.x, scale.y, scale.z}) +
                             glm::length(object.transform.translation);
        if (placed && std::isfinite(reach) && reach > ProblemList::kLargest)
            problems.fatal(where, "the object reaches too far with its scale",
                           "all of it stays within 1e15 of the origin");
    }
}

}  // namespace tp
