// Accessors: lists of numbers in the buffers of a glTF file, of any component type, sparse or not.
#pragma once

#include "gltf_document.h"

#include <teapath/scene/mesh.h>

#include <string>
#include <vector>

namespace tp {

/// The accessor with that index. Throws Error(Input) at `where` if there is none, or if its numbers
/// are not all inside the buffers; what it lacks (a buffer view) is zeros.
const tinygltf::Accessor& checked_accessor(const GltfDocument& document, int index,
                                           const std::string& where);

/// Numbers that each element has: 3 for VEC3.
int components_of(const tinygltf::Accessor& accessor);

/// All elements as floats, one after the other; normalised whole numbers become 0 to 1 or -1 to 1.
std::vector<float> read_floats(const GltfDocument& document, int index, const std::string& where);

/// The elements as vectors of that length. Throws Error(Input) if they have another.
template <class Vector>
std::vector<Vector> read_vectors(const GltfDocument& document, int index, const std::string& where);

extern template std::vector<Float2> read_vectors(const GltfDocument&, int, const std::string&);
extern template std::vector<Float3> read_vectors(const GltfDocument&, int, const std::string&);
extern template std::vector<Float4> read_vectors(const GltfDocument&, int, const std::string&);

/// Scalars of whole numbers. Throws Error(Input) for other types.
std::vector<uint32_t> read_indices(const GltfDocument& document, int index,
                                   const std::string& where);

}  // namespace tp
