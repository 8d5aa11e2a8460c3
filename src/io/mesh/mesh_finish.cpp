#include "mesh_finish.h"

#include <teapath/core/error.h>

#include <utility>

namespace tp {
namespace {

bool all_indices_in_range(const Mesh& mesh) {
    for (const auto& triangle : mesh.triangles)
        for (const uint32_t index : triangle)
            if (index >= mesh.positions.size()) return false;
    return true;
}

}  // namespace

void flip_v(std::vector<Float2>& uvs) {
    for (Float2& uv : uvs)
        uv.y = 1 - uv.y;
}

Mesh finish_mesh(Mesh mesh, const std::string& name) {
    if (mesh.triangles.empty())
        throw Error(ErrorKind::Input, "there are no triangles in it", name,
                    "points and lines alone cannot be shown");
    const bool fits = mesh.normals.empty() || mesh.normals.size() == mesh.positions.size();
    if (fits && all_indices_in_range(mesh)) mend_attributes(mesh);
    if (std::string problem = problem_of(mesh); !problem.empty())
        throw Error(ErrorKind::Input, std::move(problem), name, "export the mesh again");
    return mesh;
}

}  // namespace tp
