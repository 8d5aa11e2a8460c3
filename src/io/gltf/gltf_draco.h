// Primitives that are compressed by KHR_draco_mesh_compression.
#pragma once

#include "gltf_document.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace draco {
class Mesh;
}

namespace tp {

class DracoMesh {
public:
    /// Decodes the primitive's triangles and attributes. Throws Error(Input) at `where`.
    DracoMesh(const GltfDocument& document, const tinygltf::Primitive& primitive,
              const std::string& where);
    ~DracoMesh();

    /// True if the attribute ("POSITION") is compressed too; others are accessors as ever.
    bool has(const std::string& attribute) const { return ids_.count(attribute) > 0; }

    /// Its numbers for each vertex, of which there must be `count`. Throws Error(Input).
    std::vector<float> numbers_of(const std::string& attribute,
                                  const tinygltf::Accessor& accessor) const;

    std::vector<uint32_t> indices() const;

private:
    const std::string& where_;
    std::unique_ptr<draco::Mesh> mesh_;
    std::map<std::string, uint32_t> ids_;
};

/// True if the primitive has the extension.
bool is_draco(const tinygltf::Primitive& primitive);

}  // namespace tp
