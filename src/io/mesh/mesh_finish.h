// What every reader of meshes does at the end: attributes put in order, and the mesh checked.
#pragma once

#include <teapath/scene/mesh.h>

#include <string>

namespace tp {

/// More vertices or triangles than this are refused: indices stay positive in 32 bits.
inline constexpr uint64_t kMaxMeshCount = uint64_t{1} << 31;

/// Turns around v, which starts at the bottom in a file, and leaves no number that is not finite.
void flip_v(std::vector<Float2>& uvs);

/// The mesh with its attributes mended. Throws Error(Input), saying what is wrong in `name`, if it
/// has no triangles or is not what scene/mesh.h promises.
Mesh finish_mesh(Mesh mesh, const std::string& name);

}  // namespace tp
