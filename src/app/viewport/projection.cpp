#include "projection.h"

#include "../fly_camera.h"

#include <teapath/device/camera_record.h>
#include <teapath/kernel/camera_ray.h>

namespace tp {
namespace {

// Half of the film of a camera that keeps lines straight, as FilmPlane has it.
Double2 half_film(const Camera& camera, double aspect) {
    const double height = seen_height(camera, 0.5);
    return camera.projection == ProjectionKind::Orthographic
               ? Double2(height * aspect, height) * 0.5
               : Double2(height * aspect, height);
}

}  // namespace

ViewRay view_ray(const Camera& camera, double aspect, double x, double y) {
    CameraRecord record = camera_record(camera, aspect);
    record.lens_radius = 0;
    const CameraRay ray =
        camera_ray(record, {static_cast<Real>(x), static_cast<Real>(y)}, 1, 1, {0, 0});
    return {Double3(ray.origin), glm::normalize(Double3(ray.direction)),
            ray.is_on_film ? static_cast<double>(ray.t_max) : 0};
}

bool keeps_lines_straight(const Camera& camera) {
    return camera.projection == ProjectionKind::Perspective ||
           camera.projection == ProjectionKind::Orthographic;
}

FilmPlane film_plane(const Camera& camera, double aspect) {
    const CameraAxes axes = axes_of(camera);
    const Double2 half = half_film(camera, aspect);
    FilmPlane film;
    film.right = axes.right * (2 * half.x);
    film.down = axes.up * (-2 * half.y);
    film.corner = film.right * (camera.shift.x - 0.5) - film.down * (camera.shift.y + 0.5);
    if (camera.projection == ProjectionKind::Perspective) film.corner += axes.forward;
    return film;
}

DoubleMat4 clip_from_world(const Camera& camera, double aspect) {
    const CameraAxes axes = axes_of(camera);
    const Double2 half = half_film(camera, aspect);
    const bool is_perspective = camera.projection == ProjectionKind::Perspective;
    const Double4 w = is_perspective ? Double4(axes.forward, 0) : Double4(0, 0, 0, 1);
    const Double4 x = Double4(axes.right / half.x, 0) - w * (2 * camera.shift.x);
    const Double4 y = Double4(axes.up / half.y, 0) - w * (2 * camera.shift.y);
    const DoubleMat4 from_camera = glm::transpose(DoubleMat4(x, y, Double4(axes.forward, 0), w));
    DoubleMat4 to_camera(1);
    to_camera[3] = Double4(-camera.look_from, 1);
    return from_camera * to_camera;
}

}  // namespace tp
