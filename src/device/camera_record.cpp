#include <teapath/device/camera_record.h>
#include <teapath/scene/scene.h>

#include <cmath>

namespace tp {
namespace {

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180;

double half_height(const Camera& camera) {
    const double half_angle = camera.vertical_fov / 2 * kRadiansPerDegree;
    switch (camera.projection) {
        case ProjectionKind::Orthographic: return camera.film_height / 2;
        case ProjectionKind::Fisheye: return half_angle;
        case ProjectionKind::Perspective:
        case ProjectionKind::Equirectangular: break;
    }
    return std::tan(half_angle);
}

}  // namespace

CameraRecord camera_record(const Camera& camera, double aspect) {
    const Double3 forward = glm::normalize(camera.look_at - camera.look_from);
    const Double3 right = glm::normalize(glm::cross(forward, camera.up));
    const double height = half_height(camera);
    CameraRecord record;
    record.projection = camera.projection;
    record.origin = Vec3(camera.look_from);
    record.forward = Vec3(forward);
    record.right = Vec3(right);
    record.up = Vec3(glm::cross(right, forward));
    record.half_height = static_cast<Real>(height);
    record.half_width = static_cast<Real>(height * aspect);
    record.shift = Vec2(camera.shift * 2.0);
    record.lens_radius = static_cast<Real>(camera.aperture / 2);
    record.blades = camera.blades;
    record.blade_cosine = static_cast<Real>(std::cos(camera.blade_rotation * kRadiansPerDegree));
    record.blade_sine = static_cast<Real>(std::sin(camera.blade_rotation * kRadiansPerDegree));
    record.focus_distance = static_cast<Real>(effective_focus_distance(camera));
    record.near_clip = static_cast<Real>(camera.near_clip);
    record.far_clip = camera.far_clip > 0 ? static_cast<Real>(camera.far_clip) : kInfinity;
    return record;
}

}  // namespace tp
