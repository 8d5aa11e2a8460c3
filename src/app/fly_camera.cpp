#include "fly_camera.h"

#include <teapath/editor/refusal.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tp {
namespace {

constexpr double kRadians = 3.14159265358979323846 / 180;
constexpr double kPoleDegrees = 1;  // how near to straight up or down one may look
constexpr double kLowestFov = 1, kHighestFov = 120, kHighestFisheyeFov = 360;
constexpr double kFilmGrowth = 1.02;  // of an orthographic film, a degree
// Look distances, in scene units and for each unit that the camera is away from the origin: below
// them look_at and look_from would become one by rounding.
constexpr double kLeastDistance = 1e-6, kLeastDistanceFarAway = 1e-8;

Double3 turned(const Double3& v, const Double3& axis, double degrees) {
    return Double3(glm::rotate(DoubleMat4(1), degrees * kRadians, axis) * Double4(v, 0));
}

// v as a unit vector, or `otherwise` where it has no direction.
Double3 direction_of(const Double3& v, const Double3& otherwise) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : otherwise;
}

// Pitch that does not pass the poles.
double limited_pitch(const Double3& view, const Double3& up, double pitch) {
    const double angle =
        std::acos(std::clamp(glm::dot(view, up), -1.0, 1.0)) / kRadians;  // from up
    // Nearer to a pole than allowed, as a file may have it: only away from it.
    const double low = std::min(0.0, angle - 180 + kPoleDegrees);
    const double high = std::max(0.0, angle - kPoleDegrees);
    return std::clamp(pitch, low, high);
}

// `moved`, or the camera before where no scene can hold that: not finite, too far away, looking
// nowhere.
Camera if_possible(const Camera& moved, const Camera& before) {
    return refusal(std::vector<Camera>{moved}).empty() ? moved : before;
}

}  // namespace

CameraAxes axes_of(const Camera& camera) {
    const Double3 up = direction_of(camera.up, {0, 1, 0});
    const Double3 forward = direction_of(camera.look_at - camera.look_from, {0, 0, -1});
    Double3 right = glm::cross(forward, up);
    if (glm::length(right) < 1e-9)
        right = glm::cross(forward, std::abs(up.x) < 0.9 ? Double3(1, 0, 0) : Double3(0, 0, 1));
    right = glm::normalize(right);
    return {right, glm::cross(right, forward), forward};
}

Camera fly(const Camera& camera, const FlyInput& input) {
    Camera moved = camera;
    const Double3 up = direction_of(camera.up, {0, 1, 0});
    CameraAxes axes = axes_of(camera);
    if (input.yaw != 0 || input.pitch != 0) {
        axes.right = turned(axes.right, up, -input.yaw);
        const Double3 sideways = turned(axes.forward, up, -input.yaw);
        axes.forward = turned(sideways, axes.right, limited_pitch(sideways, up, input.pitch));
    }
    Double3 direction = axes.right * input.right + up * input.up + axes.forward * input.forward;
    const double length = glm::length(direction);
    if (length > 1) direction /= length;
    if (length == 0 && input.yaw == 0 && input.pitch == 0) return camera;
    if (length > 0) moved.look_from += direction * (input.speed * input.seconds);
    const double distance =
        std::max({glm::distance(camera.look_from, camera.look_at), kLeastDistance,
                  kLeastDistanceFarAway * glm::length(moved.look_from)});
    moved.look_at = moved.look_from + axes.forward * distance;
    return if_possible(moved, camera);
}

Camera orbit(const Camera& camera, const Double3& pivot, double yaw, double pitch) {
    if (yaw == 0 && pitch == 0) return camera;
    Camera moved = camera;
    const Double3 up = direction_of(camera.up, {0, 1, 0});
    const CameraAxes axes = axes_of(camera);
    const double limited = limited_pitch(axes.forward, up, pitch);
    const auto turn = [&](const Double3& v) {
        return turned(turned(v, axes.right, limited), up, -yaw);
    };
    moved.look_from = pivot + turn(camera.look_from - pivot);
    moved.look_at = moved.look_from + turn(camera.look_at - camera.look_from);
    return if_possible(moved, camera);
}

Camera pan(const Camera& camera, const Double2& pixels, double height, double depth) {
    const CameraAxes axes = axes_of(camera);
    const double unit = seen_height(camera, depth) / height;
    const Double3 shift = (axes.up * pixels.y - axes.right * pixels.x) * unit;
    Camera moved = camera;
    moved.look_from += shift;
    moved.look_at += shift;
    return if_possible(moved, camera);
}

double seen_height(const Camera& camera, double distance) {
    double degrees = camera.vertical_fov;
    switch (camera.projection) {
        case ProjectionKind::Orthographic: return camera.film_height;
        case ProjectionKind::Fisheye: degrees = std::min(degrees, kHighestFov); break;
        case ProjectionKind::Equirectangular: degrees = kHighestFov; break;
        case ProjectionKind::Perspective: break;
    }
    return 2 * distance * std::tan(degrees * kRadians / 2);
}

Camera widened(const Camera& camera, double degrees) {
    Camera moved = camera;
    if (camera.projection == ProjectionKind::Orthographic) {
        moved.film_height *= std::pow(kFilmGrowth, degrees);
    } else if (camera.projection != ProjectionKind::Equirectangular) {
        const double fov = camera.vertical_fov;
        const double highest =
            camera.projection == ProjectionKind::Fisheye ? kHighestFisheyeFov : kHighestFov;
        moved.vertical_fov =
            std::clamp(fov + degrees, std::min(fov, kLowestFov), std::max(fov, highest));
    }
    return if_possible(moved, camera);
}

Camera frame(const Camera& camera, const Double3& center, double radius, double aspect) {
    constexpr double kMargin = 1.2;
    Camera moved = camera;
    const double narrow = std::min(1.0, aspect);
    double distance = kMargin * radius / std::sin(std::atan(seen_height(camera, 0.5) * narrow));
    if (camera.projection == ProjectionKind::Orthographic) {
        moved.film_height = 2 * kMargin * radius / narrow;
        distance = std::max(glm::distance(camera.look_from, camera.look_at), 2 * radius);
    }
    moved.look_at = center;
    moved.look_from = center - axes_of(camera).forward * distance;
    return if_possible(moved, camera);
}

}  // namespace tp
