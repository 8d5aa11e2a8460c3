// What the outline of a selected object is drawn from: a form of unit size and its place in the
// world, which the shaders selection.vert and selection.frag trace pixel by pixel. Pure functions.
#pragma once

#include <teapath/scene/camera.h>
#include <teapath/scene/object.h>

#include <cstdint>

namespace tp {

/// Forms within [-1, 1] on each axis; the flat ones lie in z = 0. The shaders know the numbers.
enum class OutlineForm : uint32_t {
    Box,        // all of the cube
    Ball,       // radius 1
    Rectangle,  // all of the square
    Disk,       // radius 1
    Triangle    // the square's corners (-1, -1), (1, -1), (-1, 1)
};

struct OutlinePart {
    OutlineForm form;
    DoubleMat4 world_from_unit;
};

OutlinePart outline_part(const Object& object);

/// From the world to clip space of a picture of this width over height: (-1, -1) is its lower left
/// corner, w the distance along the view axis, z 0.
DoubleMat4 clip_from_world(const Camera& camera, double aspect);

}  // namespace tp
