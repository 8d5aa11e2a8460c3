// A triangle mesh in memory, as a file held it. Shared and immutable once made.
#pragma once

#include <teapath/core/math.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tp {

using Float2 = glm::vec2;
using Float3 = glm::vec3;
using Float4 = glm::vec4;

/// Indexed triangles. Every index is below positions.size(), every number finite: readers see to
/// it, and whoever makes one by hand looks at problem_of. Attributes are by vertex, each list as
/// long as `positions` or empty.
struct Mesh {
    std::vector<Float3> positions;                   // scene units
    std::vector<std::array<uint32_t, 3>> triangles;  // counter-clockwise is front
    std::vector<Float3> normals;                     // unit; empty: flat triangles
    std::vector<Float4> tangents;                    // unit, w = 1 or -1: bitangent = w * n x t
    std::vector<std::vector<Float2>> uvs;            // sets of texture coordinates, v = 0 on top
    std::vector<Float4> colors;                      // linear, with alpha; multiply the material's
    Float3 low{0, 0, 0}, high{0, 0, 0};              // box of the positions; share() fills it in

    friend bool operator==(const Mesh&, const Mesh&) = default;
};

/// Bytes that the lists of a mesh take.
size_t bytes_of(const Mesh& mesh);

/// What makes the mesh unfit, in words ("index 12 of triangle 3 is beyond the 8 vertices"); empty
/// if nothing does.
std::string problem_of(const Mesh& mesh);

/// Normals and tangents made unit; where one has no direction it is taken from the triangles
/// around its vertex. Texture coordinates that are no numbers become 0.
void mend_attributes(Mesh& mesh);

/// The mesh as scenes hold it, with its box.
std::shared_ptr<const Mesh> share(Mesh mesh);

/// A mesh and where it came from: a file, relative to the scene's, with the part of it after `#`
/// where it holds several. Equal when the paths are: meshes are loaded, not edited.
struct MeshFile {
    std::string path;
    std::shared_ptr<const Mesh> mesh;  // null: missing, nothing is shown

    friend bool operator==(const MeshFile& a, const MeshFile& b) { return a.path == b.path; }
};

}  // namespace tp
