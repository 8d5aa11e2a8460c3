// A mesh and its placements, as a kernel sees them. Every mesh has arrays of its own, so that
// bringing one or taking one away moves no other; instances share them.
#pragma once

#include <teapath/kernel/bvh_node.h>
#include <teapath/kernel/kinds.h>

namespace tp {

/// A corner of a triangle, 16 bytes in float: where it is, and whose attributes it has.
struct alignas(16) MeshCorner {
    Vec3 position;  // in the mesh's space
    uint32_t vertex;
};
struct MeshTriangle {
    MeshCorner a, b, c;  // counter-clockwise is front
};

/// By vertex; null where the mesh has none. v = 0 is the top of an image.
struct MeshAttributes {
    const Vec3* normals = nullptr;
    const Vec4* tangents = nullptr;  // w: sign of the bitangent w * n x t
    const Vec2* uvs[kUvSets] = {nullptr, nullptr};
    const Vec4* colors = nullptr;  // linear, with alpha
};

struct MeshView {
    Span<const BvhNode> nodes;
    Span<const MeshTriangle> triangles;  // in the order of the tree's leaves
    MeshAttributes attributes;
};

/// A linear map and a shift: world = linear * object + offset.
struct Affine {
    Mat3 linear{1};
    Vec3 offset{0, 0, 0};

    TP_HD_MEMBER Vec3 point(Vec3 p) const { return linear * p + offset; }
};

TP_HD bool is_finite(const Affine& a) {
    return is_finite(a.linear[0]) && is_finite(a.linear[1]) && is_finite(a.linear[2]) &&
           is_finite(a.offset);
}

struct InstanceRecord {
    Affine world_from_object;
    Affine object_from_world;
    uint32_t mesh = 0;    // index of the MeshView
    bool smooth = false;  // shade by interpolated normals
};

/// The union's member of Hittable: triangles cost spheres nothing.
struct MeshInstance {
    Bounds bounds;  // in world space
    uint32_t instance;
};

}  // namespace tp
