#include "flatten_shapes.h"

#include <cmath>

namespace tp {
namespace {

// The object's placement in double: world = linear * object + translation.
struct Placement {
    DoubleMat3 linear;
    Double3 translation;
    bool mirrors;

    Double3 point(const Double3& p) const { return linear * p + translation; }
};

// A flat shape: `turned` says that its front is against edge_u x edge_v.
template <class Shape>
std::optional<Hittable> make_flat(HittableKind kind, const Placement& place, const Double3& corner,
                                  const Double3& edge_u, const Double3& edge_v, bool turned) {
    const Double3 u = place.linear * edge_u, v = place.linear * edge_v;
    if (!(glm::length(glm::cross(u, v)) > 0)) return std::nullopt;
    Hittable h;
    h.kind = kind;
    Shape shape;
    shape.corner = Vec3(place.point(corner));
    shape.edge_u = Vec3(u);
    shape.edge_v = Vec3(v);
    if constexpr (std::is_same_v<Shape, Rectangle>) h.rectangle = shape;
    if constexpr (std::is_same_v<Shape, Disk>) h.disk = shape;
    if constexpr (std::is_same_v<Shape, Triangle>) h.triangle = shape;
    h.inside_out = turned != place.mirrors;
    return h;
}

// The image of a unit body under `axes` (columns: half axes in world space).
UnitBody make_body(const Double3& center, const DoubleMat3& axes) {
    return {Vec3(center), Mat3(glm::inverse(axes))};
}

bool is_uniform_scale(const DoubleMat3& m) {
    const double s = std::abs(m[0][0]);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (std::abs(m[column][row] - (column == row ? m[0][0] : 0)) > 1e-12 * s) return false;
    return m[0][0] > 0;
}

struct Flattener {
    const Placement& place;

    std::optional<Hittable> operator()(const SphereShape& s) const {
        const double radius = std::abs(s.radius);
        if (!(radius > 0)) return std::nullopt;
        Hittable h;
        h.inside_out = s.radius < 0;
        const Double3 center = place.point(s.center);
        if (is_uniform_scale(place.linear)) {
            h.kind = HittableKind::Sphere;
            h.sphere = {Vec3(center), static_cast<Real>(radius * place.linear[0][0])};
        } else {
            h.kind = HittableKind::Ellipsoid;
            h.ellipsoid = Ellipsoid{make_body(center, place.linear * DoubleMat3(radius))};
        }
        return h;
    }

    std::optional<Hittable> operator()(const XyRectShape& r) const {
        const Double2 size = r.high - r.low;
        return make_flat<Rectangle>(HittableKind::Rectangle, place, {r.low.x, r.high.y, r.k},
                                    {size.x, 0, 0}, {0, -size.y, 0}, true);
    }

    std::optional<Hittable> operator()(const XzRectShape& r) const {
        const Double2 size = r.high - r.low;
        return make_flat<Rectangle>(HittableKind::Rectangle, place, {r.low.x, r.k, r.low.y},
                                    {size.x, 0, 0}, {0, 0, size.y}, true);
    }

    std::optional<Hittable> operator()(const YzRectShape& r) const {
        const Double2 size = r.high - r.low;
        return make_flat<Rectangle>(HittableKind::Rectangle, place, {r.k, r.high.x, r.high.y},
                                    {0, 0, -size.y}, {0, -size.x, 0}, true);
    }

    std::optional<Hittable> operator()(const RectangleShape& r) const {
        return make_flat<Rectangle>(HittableKind::Rectangle, place, r.corner, r.edge_u, r.edge_v,
                                    false);
    }

    std::optional<Hittable> operator()(const BoxShape& b) const {
        const Double3 half = (b.high - b.low) * 0.5;
        if (!(std::abs(half.x * half.y * half.z) > 0)) return std::nullopt;
        Hittable h;
        h.kind = HittableKind::Box;
        DoubleMat3 axes = place.linear;
        for (int i = 0; i < 3; ++i)
            axes[i] *= std::abs(half[i]);
        h.box = Box{make_body(place.point((b.low + b.high) * 0.5), axes)};
        return h;
    }

    std::optional<Hittable> operator()(const DiskShape& d) const {
        const double length = glm::length(d.normal);
        if (!(length > 0) || d.radius == 0) return std::nullopt;
        const Double3 n = d.normal / length;
        const Double3 helper = std::abs(n.x) > 0.9 ? Double3(0, 1, 0) : Double3(1, 0, 0);
        const Double3 u = glm::normalize(glm::cross(helper, n)) * std::abs(d.radius);
        return make_flat<Disk>(HittableKind::Disk, place, d.center, u, glm::cross(n, u), false);
    }

    // Its place in the arrays is given later, by flatten_meshes.
    std::optional<Hittable> operator()(const MeshShape& m) const {
        if (!m.file.mesh || m.file.mesh->triangles.empty()) return std::nullopt;
        Hittable h;
        h.kind = HittableKind::Mesh;
        h.mesh = {};
        return h;
    }

    std::optional<Hittable> operator()(const TriangleShape& t) const {
        return make_flat<Triangle>(HittableKind::Triangle, place, t.a, t.b - t.a, t.c - t.a, false);
    }
};

}  // namespace

std::optional<Hittable> flatten_shape(const Object& object) {
    const DoubleMat3 linear = linear_part(object.transform);
    const double determinant = glm::determinant(linear);
    if (determinant == 0) return std::nullopt;
    const Placement place{linear, object.transform.translation, determinant < 0};
    std::optional<Hittable> h = std::visit(Flattener{place}, object.shape);
    if (h && object.inside_out) h->inside_out = !h->inside_out;
    return h;
}

}  // namespace tp
