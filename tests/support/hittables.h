// Hittables made in code, and one of each kind.
#pragma once

#include <teapath/kernel/hittable.h>

#include <vector>

namespace tp::test {

inline Hittable sphere(Vec3 center, Real radius) {
    Hittable h;
    h.sphere = {center, radius};
    return h;
}
inline Hittable ellipsoid(Vec3 center, const Mat3& axes) {
    Hittable h;
    h.kind = HittableKind::Ellipsoid;
    h.ellipsoid = Ellipsoid{{center, glm::inverse(axes)}};
    return h;
}
inline Hittable box(Vec3 center, const Mat3& axes) {
    Hittable h;
    h.kind = HittableKind::Box;
    h.box = Box{{center, glm::inverse(axes)}};
    return h;
}
inline Hittable flat(HittableKind kind, Vec3 corner, Vec3 u, Vec3 v) {
    Hittable h;
    h.kind = kind;
    const Flat f{corner, u, v};
    if (kind == HittableKind::Rectangle) h.rectangle = Rectangle{f};
    if (kind == HittableKind::Disk) h.disk = Disk{f};
    if (kind == HittableKind::Triangle) h.triangle = Triangle{f};
    return h;
}

inline const Mat3 kAxes(Vec3(Real(0.9), Real(0.2), 0), Vec3(Real(-0.1), Real(0.5), Real(0.1)),
                        Vec3(0, Real(0.3), Real(1.4)));

/// One hittable of every kind, about as large as the unit sphere, around the origin.
inline std::vector<Hittable> one_of_each() {
    return {sphere({0, 0, 0}, 1),
            ellipsoid({0, 0, 0}, kAxes),
            box({0, 0, 0}, kAxes),
            flat(HittableKind::Rectangle, {-1, 0, -1}, {2, 0, 0}, {0, Real(0.5), 2}),
            flat(HittableKind::Disk, {0, 0, 0}, {1, 0, 0}, {0, Real(0.3), Real(0.8)}),
            flat(HittableKind::Triangle, {-1, -1, 0}, {2, 0, Real(0.5)}, {0, 2, 0})};
}

}  // namespace tp::test
