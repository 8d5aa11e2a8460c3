// What the camera sees first, for the feature planes: a pass of its own, since every sample's
// camera ray can be made again from its number.
#pragma once

#include <teapath/kernel/film_view.h>
#include <teapath/kernel/path_steps.h>

namespace tp {

/// Adds a colour to the albedo, if it is one.
TP_HD void add_albedo(FeatureSum& sum, Vec3 albedo) {
    if (fits_film(albedo)) sum.albedo += albedo;
}

/// Adds what sample `sample` of pixel (x, y) meets first.
template <uint32_t kFeatures>
TP_HD void add_features(const LaunchParams& params, uint32_t x, uint32_t y, uint64_t sample,
                        FeatureSum& sum) {
    const Sampler sampler =
        path_sampler(params, y * static_cast<uint32_t>(params.width) + x, sample);
    const PathState path = start_camera_path<kFeatures>(params, sampler, x, y);
    const Hit hit = intersect<kFeatures>(params, path);
    if (hit.index == kNoHit) {
        add_albedo(sum, background_radiance<kFeatures>(params.scene, path.direction));
        return;
    }
    const Hittable& hittable = params.scene.hittables[hit.index];
    const MaterialRecord& material = params.scene.materials[hittable.material];
    const Surface s =
        make_surface<kFeatures>(params.scene, hittable, path.origin, path.direction, hit);
    add_albedo(sum, albedo_of<kFeatures>(params.scene, material, s));
    sum.normal += s.normal;
    sum.depth += depth_of(params.camera, s.point.position);
    sum.hits += 1;
}

/// The hittable at the middle of pixel (x, y) through the middle of the lens, or kNoHit.
template <uint32_t kFeatures>
TP_HD uint32_t hittable_at(const LaunchParams& params, Real x, Real y) {
    CameraRecord pinhole = params.camera;
    pinhole.lens_radius = 0;
    const CameraRay ray = camera_ray(pinhole, {x, y}, static_cast<Real>(params.width),
                                     static_cast<Real>(params.height), {0, 0});
    PathState path;
    path.origin = ray.origin;
    path.direction = ray.direction;
    path.t_max = ray.t_max;
    skip_to_scene(params.scene, path);
    return intersect<kFeatures>(params, path).index;
}

}  // namespace tp
