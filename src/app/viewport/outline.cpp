#include "outline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {
namespace {

constexpr double kLeastRadius = 1e-12;  // of a ball, so that it keeps an inverse

// The place of a form whose axes and middle are these.
DoubleMat4 placed(const Double3& x, const Double3& y, const Double3& z, const Double3& middle) {
    return {Double4(x, 0), Double4(y, 0), Double4(z, 0), Double4(middle, 1)};
}

// A parallelogram from its corner and edges.
DoubleMat4 spanned(const Double3& corner, const Double3& u, const Double3& v) {
    return placed(u * 0.5, v * 0.5, {}, corner + (u + v) * 0.5);
}

// Two unit vectors across a unit vector.
std::pair<Double3, Double3> across(const Double3& n) {
    const Double3 helper = std::abs(n.x) > 0.9 ? Double3(0, 1, 0) : Double3(1, 0, 0);
    const Double3 u = glm::normalize(glm::cross(helper, n));
    return {u, glm::cross(n, u)};
}

// The shapes in their own space.
struct MakePart {
    OutlinePart operator()(const SphereShape& s) const {
        const double radius = std::max(kLeastRadius, std::abs(s.radius));
        return {OutlineForm::Ball,
                placed({radius, 0, 0}, {0, radius, 0}, {0, 0, radius}, s.center)};
    }
    OutlinePart operator()(const XyRectShape& r) const {
        const Double2 size = r.high - r.low;
        return {OutlineForm::Rectangle,
                spanned({r.low.x, r.low.y, r.k}, {size.x, 0, 0}, {0, size.y, 0})};
    }
    OutlinePart operator()(const XzRectShape& r) const {
        const Double2 size = r.high - r.low;
        return {OutlineForm::Rectangle,
                spanned({r.low.x, r.k, r.low.y}, {size.x, 0, 0}, {0, 0, size.y})};
    }
    OutlinePart operator()(const YzRectShape& r) const {
        const Double2 size = r.high - r.low;
        return {OutlineForm::Rectangle,
                spanned({r.k, r.low.x, r.low.y}, {0, size.x, 0}, {0, 0, size.y})};
    }
    OutlinePart operator()(const RectangleShape& r) const {
        return {OutlineForm::Rectangle, spanned(r.corner, r.edge_u, r.edge_v)};
    }
    OutlinePart operator()(const BoxShape& b) const {
        const Double3 half = (b.high - b.low) * 0.5;
        return {OutlineForm::Box,
                placed({half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}, (b.low + b.high) * 0.5)};
    }
    OutlinePart operator()(const DiskShape& d) const {
        const double length = glm::length(d.normal);
        const auto [u, v] = across(length > 0 ? d.normal / length : Double3(0, 1, 0));
        return {OutlineForm::Disk, placed(u * d.radius, v * d.radius, {}, d.center)};
    }
    OutlinePart operator()(const TriangleShape& t) const {
        return {OutlineForm::Triangle, spanned(t.a, t.b - t.a, t.c - t.a)};
    }
    OutlinePart operator()(const MeshShape& m) const {
        if (!m.file.mesh) return {OutlineForm::Box, placed({.5, 0, 0}, {0, .5, 0}, {0, 0, .5}, {})};
        const DoubleMat4 placement(m.placement);
        if (!box_for_mesh) return {OutlineForm::Mesh, placement, m.file.mesh};
        const Double3 low = m.file.mesh->low, high = m.file.mesh->high;
        const Double3 half = (high - low) * 0.5;
        return {OutlineForm::Box, placement * placed({half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z},
                                                     (low + high) * 0.5)};
    }

    bool box_for_mesh = false;
};

}  // namespace

OutlinePart outline_part(const Object& object, bool box_for_mesh) {
    OutlinePart part = std::visit(MakePart{box_for_mesh}, object.shape);
    part.world_from_unit = world_from_object(object.transform) * part.world_from_unit;
    return part;
}

std::vector<OutlinePart> outline_parts(const std::vector<const Object*>& objects,
                                       size_t most_triangles) {
    std::vector<OutlinePart> parts;
    for (const Object* object : objects) {
        if (!object->visible) continue;
        const auto* shape = std::get_if<MeshShape>(&object->shape);
        const size_t triangles = shape && shape->file.mesh ? shape->file.mesh->triangles.size() : 0;
        const bool is_too_fine = triangles > most_triangles;
        if (!is_too_fine) most_triangles -= triangles;
        parts.push_back(outline_part(*object, is_too_fine));
    }
    return parts;
}

}  // namespace tp
