// Polygons of a file to triangles.
#pragma once

#include <teapath/scene/mesh.h>

#include <vector>

namespace tp {

/// Cuts polygons into triangles with the same vertices: convex ones into a fan, concave ones by
/// cutting ears (Meisters 1975), those that cross themselves or have more than 1024 corners into a
/// fan as well. Keeps its memory between calls.
class PolygonCutter {
public:
    /// Appends the triangles of the polygon with these positions; `corners[i]` is what to write
    /// for corner i. Fewer than three corners give nothing.
    void cut(const Float3* positions, const uint32_t* corners, size_t count,
             std::vector<std::array<uint32_t, 3>>& triangles);

private:
    void flatten(const Float3* positions, size_t count);
    bool is_convex() const;
    bool is_ear(size_t before, size_t at, size_t after) const;

    std::vector<Double2> points_;  // the polygon in its plane, counter-clockwise
    std::vector<size_t> left_;     // corners that are not cut off yet
};

}  // namespace tp
