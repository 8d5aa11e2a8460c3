// What the text of a Wavefront OBJ file says, before it becomes meshes. The library tinyobjloader
// reads the lines; indices are checked here, while it is known what stands before them.
#pragma once

#include <teapath/scene/mesh.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

inline constexpr uint32_t kNoIndex = ~uint32_t{0};

/// One corner of a face; kNoIndex where the file gives no texture coordinate or normal.
struct ObjCorner {
    uint32_t position, uv, normal;
};

/// The faces of one group that have one material.
struct ObjPart {
    std::string group;     // "object", "group" or "object/group"; may be empty
    std::string material;  // as usemtl has it; may be empty
    std::vector<ObjCorner> corners;
    std::vector<uint32_t> sizes;  // corners of each face
};

struct ObjText {
    std::vector<Float3> positions, normals;
    std::vector<Float2> uvs;             // v = 0 on top
    std::vector<Float4> colors;          // of the positions, linear; empty if any has none
    std::vector<ObjPart> parts;          // in the order of their first face
    size_t lines_and_points = 0;         // commands l and p, which are left out
    std::vector<std::string> libraries;  // what stands behind each mtllib
};

/// `tick` (or none) is called for every kObjTick vertices and faces, and may throw. Throws
/// Error(Input) with the number of the face.
ObjText parse_obj(std::string_view bytes, const std::string& name,
                  const std::function<void()>& tick);

inline constexpr uint64_t kObjTick = 65536;

/// The mesh of each part, not finished (see finish_mesh): equal corners are one vertex.
std::vector<Mesh> meshes_of(const ObjText& text);

}  // namespace tp
