#include <teapath/scene/transform.h>

#include <cmath>

namespace tp {
namespace {

// Rotation by `degrees` about axis 0, 1 or 2; multiples of 90 degrees are exact.
DoubleMat3 rotation_about(int axis, double degrees) {
    const double turn = std::fmod(degrees, 360.0);
    double c = std::cos(turn * 3.14159265358979323846 / 180);
    double s = std::sin(turn * 3.14159265358979323846 / 180);
    if (std::fmod(turn, 90.0) == 0) {
        c = std::round(c);
        s = std::round(s);
    }
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    DoubleMat3 m(1);
    m[j][j] = c;
    m[k][k] = c;
    m[j][k] = s;
    m[k][j] = -s;
    return m;
}

}  // namespace

DoubleMat3 linear_part(const Transform& t) {
    DoubleMat3 m = rotation_about(2, t.rotation.z) * rotation_about(1, t.rotation.y) *
                   rotation_about(0, t.rotation.x);
    for (int axis = 0; axis < 3; ++axis)
        m[axis] *= t.scale[axis];
    return m;
}

DoubleMat4 world_from_object(const Transform& t) {
    DoubleMat4 m(linear_part(t));
    m[3] = Double4(t.translation, 1);
    return m;
}

}  // namespace tp
