// Meshes that are made, not read: named in scene files by "procedural://knot?p=2&q=3" in place of a
// path. The same name gives the same mesh, on every machine up to rounding.
#pragma once

#include <teapath/scene/mesh.h>

#include <string_view>

namespace tp {

/// True if a MeshFile::path names such a mesh.
bool is_procedural(std::string_view path);

/// Makes it. Throws Error(Input) where the name, a parameter or its range is wrong.
Mesh procedural_mesh(std::string_view path);

/// What there is, for menus and messages.
struct ProceduralKind {
    const char* name;        // in the path
    const char* label;       // in menus
    const char* parameters;  // with their defaults, as they stand behind the question mark
};
const std::vector<ProceduralKind>& procedural_kinds();

}  // namespace tp
