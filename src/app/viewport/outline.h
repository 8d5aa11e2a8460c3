// What the outline of a selected object is drawn from: a form of unit size and its place in the
// world, which the shaders selection.vert and selection.frag trace pixel by pixel. Pure functions.
#pragma once

#include <teapath/scene/object.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace tp {

/// Forms within [-1, 1] on each axis; the flat ones lie in z = 0. The shaders know the numbers.
enum class OutlineForm : uint32_t {
    Box,        // all of the cube
    Ball,       // radius 1
    Rectangle,  // all of the square
    Disk,       // radius 1
    Triangle,   // the square's corners (-1, -1), (1, -1), (-1, 1)
    Mesh        // the mesh itself, in its own space
};

struct OutlinePart {
    OutlineForm form;
    DoubleMat4 world_from_unit;
    std::shared_ptr<const Mesh> mesh = nullptr;  // of the form Mesh alone
};

/// A mesh is its own outline, or else its box.
OutlinePart outline_part(const Object& object, bool box_for_mesh = false);
/// Those of the visible ones. Meshes beyond that many triangles in all are boxes.
std::vector<OutlinePart> outline_parts(const std::vector<const Object*>& objects,
                                       size_t most_triangles);

}  // namespace tp
