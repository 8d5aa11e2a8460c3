// Primitives of a glTF file as meshes.
#pragma once

#include "gltf_document.h"
#include "gltf_pose.h"

#include <teapath/scene/mesh.h>

#include <string>
#include <vector>

namespace tp {

/// The triangles of a primitive (list, strip or fan), not checked yet (see finish_mesh). Throws
/// Error(Input) at `where` if attributes do not fit together. With `skin`, its joints and weights
/// are read too.
Mesh read_primitive(const GltfDocument& document, const tinygltf::Primitive& primitive,
                    const std::string& where, SkinWeights* skin = nullptr);

/// Bytes that its mesh will take at most. Throws Error(Input) as read_primitive does.
double bytes_of_primitive(const GltfDocument& document, const tinygltf::Primitive& primitive,
                          const std::string& where);

/// True for triangles; points and lines cannot be shown.
bool has_triangles(const tinygltf::Primitive& primitive);

}  // namespace tp
