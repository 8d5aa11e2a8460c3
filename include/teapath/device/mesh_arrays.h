// A mesh as the kernels read it: its tree, its triangles in the order of the tree's leaves, its
// attributes. Made once for each mesh, whatever instances, scenes and renders use it.
#pragma once

#include <teapath/device/bvh_stats.h>
#include <teapath/kernel/mesh/mesh_view.h>
#include <teapath/scene/mesh.h>

#include <array>
#include <memory>
#include <vector>

namespace tp {

struct MeshArrays {
    std::vector<BvhNode> nodes;
    std::vector<MeshTriangle> triangles;
    std::vector<Vec3> normals;
    std::vector<Vec4> tangents;
    std::array<std::vector<Vec2>, kUvSets> uvs;
    std::vector<Vec4> colors;
    Bounds bounds;
    BvhStats bvh;

    size_t bytes() const;
    MeshView view() const;  // of these arrays, in the host's memory
};

/// The arrays of a mesh without problems (problem_of finds none). Shared with whoever asked for
/// those of the same mesh before and still holds them.
std::shared_ptr<const MeshArrays> arrays_of(const std::shared_ptr<const Mesh>& mesh);

}  // namespace tp
