// The union-tagged hittable: { kind, union } with one switch per operation. A new shape is a file
// in shapes/, a member of the union, a case in each switch here, a row in the enum table, a test.
#pragma once

#include <teapath/core/host_device.h>
#include <teapath/kernel/kinds.h>
#include <teapath/kernel/mesh/mesh_view.h>
#include <teapath/kernel/shapes/box.h>
#include <teapath/kernel/shapes/ellipsoid.h>
#include <teapath/kernel/shapes/flat.h>
#include <teapath/kernel/shapes/sphere.h>

namespace tp {

struct alignas(16) Hittable {
    union {
        Sphere sphere;
        Ellipsoid ellipsoid;
        Rectangle rectangle;
        Box box;
        Disk disk;
        Triangle triangle;
        MeshInstance mesh;
    };
    HittableKind kind;
    uint8_t inside_out;   // 1: the normal is turned round
    uint8_t hidden_from;  // bits of RayKind
    uint8_t unused;
    uint32_t material;  // index of the MaterialRecord
    uint32_t object;    // ObjectId::value
    uint32_t light;     // index of the LightRecord, of a mesh's first triangle; kNoLight = none

    TP_HD_MEMBER Hittable()
        : sphere{},
          kind(HittableKind::Sphere),
          inside_out(0),
          hidden_from(0),
          unused(0),
          material(0),
          object(0),
          light(0xffffffff) {}
};
/// What a ray is for, as bits of Hittable::hidden_from.
enum RayKind : uint8_t { kRayCamera = 1, kRayShadow = 2, kRayScattered = 4 };

/// True if the hittable's normal points into a closed shape.
TP_HD bool is_turned_inwards(const Hittable& h) {
    const bool is_closed = h.kind == HittableKind::Sphere || h.kind == HittableKind::Ellipsoid ||
                           h.kind == HittableKind::Box;
    return is_closed && h.inside_out;
}

inline constexpr uint32_t kNoLight = 0xffffffff;
static_assert(sizeof(Real) == 8 || sizeof(Hittable) == 64, "48 bytes of shape, 16 of tags");

/// Calls `f` with the shape in the union: the one switch over kinds. A mesh is no such shape: it
/// is answered for from its pool, in mesh/.
template <class F>
TP_HD auto with_shape(const Hittable& h, F&& f) {
    TP_ASSERT(h.kind != HittableKind::Mesh);
    switch (h.kind) {
        case HittableKind::Ellipsoid: return f(h.ellipsoid);
        case HittableKind::Rectangle: return f(h.rectangle);
        case HittableKind::Box: return f(h.box);
        case HittableKind::Disk: return f(h.disk);
        case HittableKind::Triangle: return f(h.triangle);
        case HittableKind::Mesh:
        case HittableKind::Sphere: break;
    }
    return f(h.sphere);
}

TP_HD Bounds bounds_of(const Hittable& h) {
    if (h.kind == HittableKind::Mesh) return h.mesh.bounds;
    return with_shape(h, [](const auto& shape) { return bounds_of(shape); });
}

TP_HD Real area_of(const Hittable& h) {
    return with_shape(h, [](const auto& shape) { return area_of(shape); });
}

/// Finds the crossing with 0 < t < t_max nearest to the origin; then fills t, u, v of `hit`.
TP_HD bool intersect(const Hittable& h, Vec3 origin, Vec3 direction, Real t_max, Hit& hit) {
    return with_shape(
        h, [&](const auto& shape) { return intersect(shape, origin, direction, t_max, hit); });
}

/// The surface where the ray met `h`, with the normal on the hittable's own side.
TP_HD SurfacePoint surface_at(const Hittable& h, Vec3 origin, Vec3 direction, const Hit& hit) {
    SurfacePoint point =
        with_shape(h, [&](const auto& shape) { return surface_at(shape, origin, direction, hit); });
    if (h.inside_out) point.normal = -point.normal;
    return point;
}

/// Texture coordinates of a point from surface_at or sample_toward: v = 0 at the top of an image.
TP_HD Vec2 texture_uv(const Hittable& h, const SurfacePoint& point) {
    return with_shape(h, [&](const auto& shape) { return texture_uv(shape, point); });
}

/// The direction of growing u at a point with this normal, and the sign of the bitangent w * n x t
/// towards the top of an image.
TP_HD Vec4 shape_tangent(const Hittable& h, Vec3 normal) {
    switch (h.kind) {
        case HittableKind::Rectangle:
        case HittableKind::Disk:
        case HittableKind::Triangle: {
            const Flat& flat = h.rectangle;
            const Vec3 bitangent = cross(normal, flat.edge_u);
            return Vec4(flat.edge_u, dot(bitangent, flat.edge_v) > 0 ? -1 : 1);
        }
        default: return Vec4(cross(Vec3(0, 1, 0), normal), 1);  // eastwards
    }
}

/// A point of `h` for light sampling as seen from `from`; pdf over solid angle.
TP_HD ShapeSample sample_toward(const Hittable& h, Vec3 from, Vec2 u) {
    ShapeSample sample =
        with_shape(h, [&](const auto& shape) { return sample_toward(shape, from, u); });
    if (h.inside_out) sample.point.normal = -sample.point.normal;
    return sample;
}

/// The pdf over solid angle that sample_toward has for a direction that met `h` at `point`.
TP_HD Real pdf_toward(const Hittable& h, Vec3 from, Vec3 direction, const SurfacePoint& point,
                      Real distance) {
    return with_shape(
        h, [&](const auto& shape) { return pdf_toward(shape, from, direction, point, distance); });
}

}  // namespace tp
