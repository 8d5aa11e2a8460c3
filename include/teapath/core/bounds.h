// Axis-aligned boxes.
#pragma once

#include <teapath/core/math.h>

namespace tp {

/// An axis-aligned box; a fresh one is empty (low = +inf, high = -inf).
struct Bounds {
    Vec3 low{kInfinity, kInfinity, kInfinity};
    Vec3 high{-kInfinity, -kInfinity, -kInfinity};

    TP_HD_MEMBER bool is_empty() const { return low.x > high.x; }
    TP_HD_MEMBER Vec3 center() const { return (low + high) * Real(0.5); }
    TP_HD_MEMBER Vec3 extent() const { return high - low; }
};

TP_HD Bounds join(const Bounds& a, const Bounds& b) {
    return {min(a.low, b.low), max(a.high, b.high)};
}
TP_HD Bounds join(const Bounds& a, Vec3 p) {
    return {min(a.low, p), max(a.high, p)};
}

/// Half of the surface area; 0 for an empty box.
TP_HD Real half_area(const Bounds& b) {
    if (b.is_empty()) return 0;
    const Vec3 e = b.extent();
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

}  // namespace tp
