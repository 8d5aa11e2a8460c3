// Camera rays: a true pinhole, or a thin lens whose plane of focus is sharp.
#pragma once

#include <teapath/kernel/records.h>
#include <teapath/kernel/warps.h>

namespace tp {

struct CameraRay {
    Vec3 origin;
    Vec3 direction;  // unit
    Real t_max;
};

/// The ray through film position `film` in pixels (x to the right, y down, of width x height) that
/// leaves the lens at `lens`, uniform in [0, 1)^2. With clip planes it starts and ends on them.
TP_HD CameraRay camera_ray(const CameraRecord& camera, Vec2 film, Real width, Real height,
                           Vec2 lens) {
    const Real x = (2 * film.x / width - 1) * camera.half_width;
    const Real y = (1 - 2 * film.y / height) * camera.half_height;
    Vec3 towards = camera.forward + camera.right * x + camera.up * y;
    Vec3 origin = camera.origin;
    if (camera.lens_radius > 0) {
        const Vec2 p = sample_uniform_disk(lens) * camera.lens_radius;
        const Vec3 offset = camera.right * p.x + camera.up * p.y;
        origin += offset;
        towards = towards * camera.focus_distance - offset;
    }
    const Vec3 direction = normalize(towards);
    const Real cosine = dot(direction, camera.forward);
    Real t_max = camera.far_clip / cosine;
    if (camera.near_clip > 0) {
        const Real t_near = camera.near_clip / cosine;
        origin += direction * t_near;
        t_max -= t_near;
    }
    return {origin, direction, t_max};
}

}  // namespace tp
