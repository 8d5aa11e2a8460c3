// Files that hold one triangle mesh: PLY, STL and OBJ without its materials.
#pragma once

#include <teapath/scene/mesh.h>

#include <filesystem>

namespace tp {

/// True if the extension (lower or upper case) is .ply, .stl or .obj.
bool can_read_mesh(const std::filesystem::path& file);

/// Reads the whole file as one mesh: PLY (ASCII, binary of both byte orders), STL (ASCII and
/// binary), OBJ (faces of any number of corners; v flipped, so that 0 is on top). What memory it
/// needs is estimated before it is taken. Throws Error(Input) with file, place and remedy.
Mesh read_mesh(const std::filesystem::path& file);

}  // namespace tp
