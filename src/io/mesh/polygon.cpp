#include "polygon.h"

#include <cmath>

namespace tp {
namespace {

constexpr size_t kMostEars = 1024;  // the time grows with the square

// Twice the area of the triangle, above 0 if it turns to the left.
double turn(Double2 a, Double2 b, Double2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

// Drops the axis along which the polygon's normal (Newell's method) is longest.
void PolygonCutter::flatten(const Float3* positions, size_t count) {
    Double3 normal(0);
    for (size_t i = 0; i < count; ++i) {
        const Double3 a = positions[i], b = positions[(i + 1) % count];
        normal += Double3((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x),
                          (a.x - b.x) * (a.y + b.y));
    }
    const Double3 size = glm::abs(normal);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double sign = normal[axis] < 0 ? -1 : 1;
    points_.resize(count);
    for (size_t i = 0; i < count; ++i) {
        const Double3 p = positions[i];
        points_[i] = {p[u] * sign, p[v]};
    }
}

bool PolygonCutter::is_convex() const {
    const size_t count = points_.size();
    for (size_t i = 0; i < count; ++i)
        if (turn(points_[i], points_[(i + 1) % count], points_[(i + 2) % count]) < 0) return false;
    return true;
}

// True if the corner turns to the left and no other corner that is left lies inside its triangle.
bool PolygonCutter::is_ear(size_t before, size_t at, size_t after) const {
    const Double2 a = points_[before], b = points_[at], c = points_[after];
    if (!(turn(a, b, c) > 0)) return false;
    for (const size_t i : left_) {
        if (i == before || i == at || i == after) continue;
        const Double2 p = points_[i];
        if (p == a || p == b || p == c) continue;  // a hole's bridge goes there and back
        if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
}

void PolygonCutter::cut(const Float3* positions, const uint32_t* corners, size_t count,
                        std::vector<std::array<uint32_t, 3>>& triangles) {
    if (count < 3) return;
    if (count == 3) {
        triangles.push_back({corners[0], corners[1], corners[2]});
        return;
    }
    // A fan where it is right, or where cutting would take too long.
    if (count <= kMostEars) flatten(positions, count);
    if (count > kMostEars || is_convex()) {
        for (size_t i = 2; i < count; ++i)
            triangles.push_back({corners[0], corners[i - 1], corners[i]});
        return;
    }

    // Ears, round and round; where none is left (the polygon crosses itself), any corner.
    left_.resize(count);
    for (size_t i = 0; i < count; ++i)
        left_[i] = i;
    size_t at = 0, failed = 0;
    while (left_.size() > 3) {
        const size_t n = left_.size();
        at %= n;
        const size_t before = left_[(at + n - 1) % n], after = left_[(at + 1) % n];
        if (failed < n && !is_ear(before, left_[at], after)) {
            ++at;
            ++failed;
            continue;
        }
        triangles.push_back({corners[before], corners[left_[at]], corners[after]});
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
        failed = 0;
    }
    triangles.push_back({corners[left_[0]], corners[left_[1]], corners[left_[2]]});
}

}  // namespace tp
