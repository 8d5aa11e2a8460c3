// One reader for each format of meshes, from bytes in memory. `name` stands for the file in
// messages; all throw Error(Input).
#pragma once

#include <teapath/scene/mesh.h>

#include <string>
#include <string_view>

namespace tp {

/// The Polygon File Format: ASCII and binary of both byte orders. Faces of any number of corners;
/// vertices with normals (nx ny nz), texture coordinates (u v, s t, texture_u texture_v) and
/// colours (whole numbers hold sRGB, others linear values).
Mesh read_ply(std::string_view bytes, const std::string& name);

/// Stereolithography: ASCII, or binary even where it starts with "solid". Corners at the same
/// place become one vertex; the triangles stay flat.
Mesh read_stl(std::string_view bytes, const std::string& name);

/// Wavefront OBJ, all its groups as one mesh, without materials.
Mesh read_obj(std::string_view bytes, const std::string& name);

}  // namespace tp
