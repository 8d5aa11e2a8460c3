// Camera rays: through a true pinhole or a thin lens whose plane of focus is sharp, parallel ones,
// and panoramas.
#pragma once

#include <teapath/kernel/records.h>
#include <teapath/kernel/warps.h>

namespace tp {

struct CameraRay {
    Vec3 origin;
    Vec3 direction;  // unit
    Real t_max;
    bool is_on_film = true;  // false: outside of a fisheye's circle, which stays black
};

/// A point of the aperture, in radii of it: round, or a regular polygon with a corner upwards.
TP_HD Vec2 sample_aperture(const CameraRecord& camera, Vec2 u) {
    if (camera.blades < 3) return sample_uniform_disk(u);
    // A triangle from the middle to one edge, then a point of it.
    const Real scaled = u.x * static_cast<Real>(camera.blades);
    const Real blade = std::floor(scaled);
    const Real r = tp::sqrt(min(scaled - blade, kOneMinusEpsilon));
    const Real step = 2 * kPi / static_cast<Real>(camera.blades);
    const Vec2 a{std::sin(blade * step), std::cos(blade * step)};
    const Vec2 b{std::sin((blade + 1) * step), std::cos((blade + 1) * step)};
    const Vec2 p = (a * (1 - u.y) + b * u.y) * r;
    return {p.x * camera.blade_cosine - p.y * camera.blade_sine,
            p.x * camera.blade_sine + p.y * camera.blade_cosine};
}

/// The direction of a panorama's film position (x, y), from -1 to 1 across the film.
TP_HD Vec3 panorama_direction(const CameraRecord& camera, Real x, Real y, bool& is_on_film) {
    if (camera.projection == ProjectionKind::Equirectangular) {
        const Real phi = x * kPi, theta = clamp(y, Real(-1), Real(1)) * kPi / 2;
        return (camera.forward * std::cos(phi) + camera.right * std::sin(phi)) * std::cos(theta) +
               camera.up * std::sin(theta);
    }
    // Equidistant: angles from the axis grow as distances from the middle of the film.
    const Vec2 angles{x * camera.half_width, y * camera.half_height};
    const Real angle = tp::sqrt(sqr(angles.x) + sqr(angles.y));
    is_on_film = angle <= camera.half_height;
    if (!(angle > 0)) return camera.forward;
    const Real across = std::sin(angle) / angle;
    return camera.forward * std::cos(angle) + camera.right * (angles.x * across) +
           camera.up * (angles.y * across);
}

TP_HD bool is_panorama(const CameraRecord& camera) {
    return camera.projection == ProjectionKind::Fisheye ||
           camera.projection == ProjectionKind::Equirectangular;
}

/// Distance of a point from the camera: along its axis, in panoramas along the ray.
TP_HD Real depth_of(const CameraRecord& camera, Vec3 position) {
    const Vec3 offset = position - camera.origin;
    return is_panorama(camera) ? length(offset) : dot(offset, camera.forward);
}

/// The ray through film position `film` in pixels (x to the right, y down, of width x height) that
/// leaves the lens at `lens`, uniform in [0, 1)^2. With clip planes it starts and ends on them.
TP_HD CameraRay camera_ray(const CameraRecord& camera, Vec2 film, Real width, Real height,
                           Vec2 lens) {
    const Real x = 2 * film.x / width - 1 + camera.shift.x;
    const Real y = 1 - 2 * film.y / height + camera.shift.y;
    CameraRay ray;
    ray.origin = camera.origin;
    Vec3 towards;
    if (is_panorama(camera)) {
        towards = panorama_direction(camera, x, y, ray.is_on_film);
    } else {
        const Vec3 across =
            camera.right * (x * camera.half_width) + camera.up * (y * camera.half_height);
        const bool is_parallel = camera.projection == ProjectionKind::Orthographic;
        if (is_parallel) ray.origin += across;
        towards = is_parallel ? camera.forward : camera.forward + across;
        if (camera.lens_radius > 0) {
            const Vec2 p = sample_aperture(camera, lens) * camera.lens_radius;
            const Vec3 offset = camera.right * p.x + camera.up * p.y;
            ray.origin += offset;
            towards = towards * camera.focus_distance - offset;
        }
    }
    ray.direction = normalize(towards);
    const Real cosine = is_panorama(camera) ? Real(1) : dot(ray.direction, camera.forward);
    ray.t_max = camera.far_clip / cosine;
    if (camera.near_clip > 0) {
        const Real t_near = camera.near_clip / cosine;
        ray.origin += ray.direction * t_near;
        ray.t_max -= t_near;
    }
    return ray;
}

}  // namespace tp
