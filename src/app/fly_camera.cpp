#include "fly_camera.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double kRadians = 3.14159265358979323846 / 180;
constexpr double kPoleDegrees = 1;  // how near to straight up or down one may look

Double3 turned(const Double3& v, const Double3& axis, double degrees) {
    return Double3(glm::rotate(DoubleMat4(1), degrees * kRadians, axis) * Double4(v, 0));
}

// Pitch that does not pass the poles.
double limited_pitch(const Double3& view, const Double3& up, double pitch) {
    const double angle =
        std::acos(std::clamp(glm::dot(view, up), -1.0, 1.0)) / kRadians;  // from up
    return std::clamp(pitch, angle - 180 + kPoleDegrees, angle - kPoleDegrees);
}

Double3 turned_view(const Double3& view, const Double3& up, double yaw, double pitch) {
    const Double3 sideways = turned(view, up, -yaw);
    const Double3 right = glm::normalize(glm::cross(sideways, up));
    return turned(sideways, right, limited_pitch(sideways, up, pitch));
}

}  // namespace

Camera fly(const Camera& camera, const FlyInput& input) {
    Camera moved = camera;
    const Double3 up = glm::normalize(camera.up);
    const double distance = glm::distance(camera.look_from, camera.look_at);
    Double3 view = (camera.look_at - camera.look_from) / distance;
    if (input.yaw != 0 || input.pitch != 0) view = turned_view(view, up, input.yaw, input.pitch);
    const Double3 right = glm::normalize(glm::cross(view, up));
    Double3 direction = right * input.right + up * input.up + view * input.forward;
    const double length = glm::length(direction);
    if (length > 1) direction /= length;
    moved.look_from += direction * (input.speed * input.seconds);
    moved.look_at = moved.look_from + view * distance;
    return moved;
}

Camera orbit(const Camera& camera, const Double3& pivot, double yaw, double pitch) {
    Camera moved = camera;
    const Double3 up = glm::normalize(camera.up);
    const Double3 view = glm::normalize(camera.look_at - camera.look_from);
    const double limited = limited_pitch(view, up, pitch);
    const Double3 right = glm::normalize(glm::cross(view, up));
    const auto turn = [&](const Double3& v) { return turned(turned(v, right, limited), up, -yaw); };
    moved.look_from = pivot + turn(camera.look_from - pivot);
    moved.look_at = moved.look_from + turn(camera.look_at - camera.look_from);
    return moved;
}

Camera frame(const Camera& camera, const Double3& center, double radius) {
    Camera moved = camera;
    const Double3 view = glm::normalize(camera.look_at - camera.look_from);
    const double distance = 1.2 * radius / std::sin(camera.vertical_fov * kRadians / 2);
    moved.look_at = center;
    moved.look_from = center - view * distance;
    return moved;
}

}  // namespace tp
