// Meshes that change their form: morph targets, which add to vertices, and skins, whose joints
// move them (glTF 2.0, 3.7.2 and 3.7.3).
#pragma once

#include <teapath/scene/mesh.h>

#include <cstdint>
#include <string>
#include <vector>

namespace tp {

/// What a target adds for each vertex at weight 1; empty lists add nothing.
struct MorphTarget {
    std::vector<Float3> positions, normals, tangents;
};

/// Which joints move each vertex and by how much: one list for each set of four, as long as the
/// positions.
struct SkinWeights {
    std::vector<std::vector<Float4>> joints, weights;
};

/// A mesh before its targets and joints act on it.
struct DeformableMesh {
    Mesh mesh;
    std::vector<MorphTarget> targets;
    SkinWeights skin;

    size_t bytes() const;
};

/// What makes targets or skin unfit for the mesh, in words; empty if nothing does. `joints` is how
/// many the skin has.
std::string problem_of(const DeformableMesh& deformable, size_t joints);

/// The mesh with weights[t] times target t added (those beyond the targets are left out), then
/// moved by `joints`, matrices from the mesh's space to where it is to be (none: not moved). Uses
/// all cores if `parallel`. Attributes are mended (mend_attributes); the box is not filled in.
/// problem_of must find nothing.
Mesh deformed(const DeformableMesh& deformable, const std::vector<double>& weights,
              const std::vector<DoubleMat4>& joints, bool parallel);

}  // namespace tp
