// Path tracing as steps on a PathState: start a camera path, intersect, shade, connect to a light,
// finish. Steps know no schedule: an executor calls them, path by path on the host, lanes of many
// paths on a GPU. kFeatures names what the scene contains; code for the rest is not compiled.
#pragma once

#include <teapath/kernel/background.h>
#include <teapath/kernel/camera_ray.h>
#include <teapath/kernel/dimensions.h>
#include <teapath/kernel/environment.h>
#include <teapath/kernel/film_view.h>
#include <teapath/kernel/launch_params.h>
#include <teapath/kernel/light.h>
#include <teapath/kernel/make_bsdf.h>
#include <teapath/kernel/path_state.h>
#include <teapath/kernel/sampler.h>
#include <teapath/kernel/traverse.h>

namespace tp {

/// Surfaces that a path may go straight through, and segments of a shadow query.
inline constexpr uint32_t kMaxPassThrough = 512;

/// The random numbers of sample `sample` of pixel `pixel` = y * width + x.
TP_HD Sampler path_sampler(const LaunchParams& params, uint32_t pixel, uint64_t sample) {
    return make_sampler(params.key, pixel, sample, params.settings.sampler,
                        params.settings.tea_rounds);
}

/// Moves the start of a far camera's ray to the scene's box, where numbers are precise again.
TP_HD void skip_to_scene(const SceneView& scene, PathState& path) {
    Real entry = 0, exit = path.t_max;
    clip_box(scene.bounds, path.origin, safe_inverse(path.direction), entry, exit);
    if (!(entry > 0 && entry < exit)) return;
    const Real skip = entry * (1 - 64 * kEpsilon);
    path.origin += path.direction * skip;
    path.t_max -= skip;
}

/// Step 1: a path through pixel (x, y).
template <uint32_t kFeatures>
TP_HD PathState start_camera_path(const LaunchParams& params, const Sampler& sampler, uint32_t x,
                                  uint32_t y) {
    const Vec2 jitter = sample_2d<(kFeatures & kFeatureSobol) != 0>(sampler, kDimensionPixel);
    Vec2 lens{0, 0};
    if (params.camera.lens_radius > 0)
        lens = sample_2d<(kFeatures & kFeatureSobol) != 0>(sampler, kDimensionLens);
    const CameraRay ray = camera_ray(
        params.camera, {static_cast<Real>(x) + jitter.x, static_cast<Real>(y) + jitter.y},
        static_cast<Real>(params.width), static_cast<Real>(params.height), lens);
    PathState path;
    path.origin = ray.origin;
    path.direction = ray.direction;
    path.t_max = ray.t_max;
    if (!ray.is_on_film) path.throughput = {0, 0, 0};
    skip_to_scene(params.scene, path);
    return path;
}

/// Step 2: what the path meets next.
template <uint32_t kFeatures>
TP_HD Hit intersect(const LaunchParams& params, const PathState& path) {
    return intersect_scene<kFeatures>(params.scene, path.origin, path.direction, path.t_max,
                                      path.depth == 1 ? kRayCamera : kRayScattered);
}

/// Sends the path on from `s` in direction `direction`.
TP_HD void leave_surface(PathState& path, const Surface& s, Vec3 direction) {
    path.origin = offset_ray_origin(s.point.position, s.point.error, s.point.normal, direction);
    path.direction = direction;
    path.t_max = kInfinity;
    ++path.vertex;
}

/// `radiance` over a path of that many segments, cut at the setting's limit; what the camera sees
/// itself is never cut.
TP_HD Vec3 clamped(const PathSettings& settings, uint32_t segments, Vec3 radiance) {
    const Real limit =
        static_cast<Real>(segments <= 2 ? settings.clamp_direct : settings.clamp_indirect);
    if (!(limit > 0) || segments <= 1) return radiance;
    const Real most = max_component(radiance);
    return most > limit ? radiance * (limit / most) : radiance;
}

/// True if the environment is one of the lights.
template <uint32_t kFeatures>
TP_HD bool aims_at_environment(const SceneView& scene) {
    constexpr uint32_t kNeeded = kFeatureLights | kFeatureTextures;
    if constexpr ((kFeatures & kNeeded) == kNeeded) return scene.background.light_probability > 0;
    return false;
}

/// The direct light of the environment at `s`, weighed against sampling the bsdf.
template <uint32_t kFeatures>
TP_HD void connect_environment(const LaunchParams& params, Vec2 u, const PathState& path,
                               const Surface& s, const Bsdf& bsdf, Vec3 wo, ShadowQuery& shadow) {
    const SceneView& scene = params.scene;
    const EnvironmentSample sample = sample_environment(scene.environment, scene.background, u);
    const Real pdf = sample.pdf * scene.background.light_probability;
    if (!(pdf > 0)) return;
    const Vec3 f = bsdf_eval<kFeatures>(bsdf, wo, sample.direction);
    if (is_black(f)) return;
    const Vec3 radiance = background_radiance<kFeatures>(scene, sample.direction);
    const Real weight = mis_weight(pdf, bsdf_pdf<kFeatures>(bsdf, wo, sample.direction));
    shadow.origin =
        offset_ray_origin(s.point.position, s.point.error, s.point.normal, sample.direction);
    shadow.direction = sample.direction;
    shadow.distance = kInfinity;
    shadow.ignored = {kNoHit, kNoHit, kRayShadow};
    shadow.contribution =
        clamped(params.settings, path.depth + 1, path.throughput * f * radiance * (weight / pdf));
    shadow.is_active = true;
}

/// The direct light of a point of a light at `s`, weighed against sampling the bsdf. `share` is the
/// probability that it is a light that is aimed at.
template <uint32_t kFeatures>
TP_HD void connect_emitter(const LaunchParams& params, const LightChoice& choice, Real share,
                           Vec2 u, const PathState& path, const Surface& s, const Bsdf& bsdf,
                           Vec3 wo, ShadowQuery& shadow) {
    // A point on the light.
    const LightRecord& light = params.scene.lights[choice.light];
    const Hittable& emitter = params.scene.hittables[light.hittable];
    const MaterialRecord& material = params.scene.materials[emitter.material];
    const ShapeSample sample = sample_emitter<kFeatures>(params.scene, light, s.point.position, u);
    const Real pdf = sample.pdf * choice.probability * share;
    const bool front = dot(sample.direction, sample.point.normal) < 0;
    if (!(pdf > 0) || !emits_towards(material, is_turned_inwards(emitter), front)) return;

    // What reflects towards wo.
    const Vec3 f = bsdf_eval<kFeatures>(bsdf, wo, sample.direction);
    if (is_black(f)) return;

    // What comes from there.
    const Surface at_light =
        surface_of_emitter<kFeatures>(params.scene, light, emitter, sample.point);
    Vec3 radiance = emitted_radiance<kFeatures>(params.scene, material, at_light) *
                    cone_share(material, dot(sample.direction, sample.point.normal));
    if (is_black(radiance)) return;
    if constexpr ((kFeatures & kFeatureOpacity) != 0)
        radiance *=
            opacity_of(material, surface_color<kFeatures>(params.scene, material, at_light).w);

    // Scattered rays do not find lights that are hidden from them.
    Real weight = 1;
    if ((emitter.hidden_from & kRayScattered) == 0)
        weight = mis_weight(pdf, bsdf_pdf<kFeatures>(bsdf, wo, sample.direction));
    shadow.origin =
        offset_ray_origin(s.point.position, s.point.error, s.point.normal, sample.direction);
    shadow.direction = sample.direction;
    shadow.distance = sample.distance;
    shadow.ignored = {light.hittable, light.primitive, kRayShadow};
    shadow.contribution =
        clamped(params.settings, path.depth + 1, path.throughput * f * radiance * (weight / pdf));
    shadow.is_active = true;
}

/// The probability that light sampling aims at the environment instead of a light.
template <uint32_t kFeatures>
TP_HD Real environment_share(const SceneView& scene) {
    return aims_at_environment<kFeatures>(scene) ? scene.background.light_probability : Real(0);
}

/// The direct light at `s`, of the environment or of a light.
template <uint32_t kFeatures>
TP_HD void sample_light(const LaunchParams& params, const Sampler& sampler, const PathState& path,
                        const Surface& s, const Bsdf& bsdf, Vec3 wo, ShadowQuery& shadow) {
    constexpr bool kSobol = (kFeatures & kFeatureSobol) != 0;
    const SceneView& scene = params.scene;
    const uint32_t dimension = vertex_dimension(path.vertex);
    const Vec2 u = sample_2d<kSobol>(sampler, dimension + kDimensionLight);
    Real which = sample_1d<kSobol>(sampler, dimension + kDimensionLightChoice);
    const Real share = 1 - environment_share<kFeatures>(scene);
    if constexpr ((kFeatures & kFeatureTextures) != 0) {
        if (which >= share)
            return connect_environment<kFeatures>(params, u, path, s, bsdf, wo, shadow);
    }
    if (scene.lights.empty()) return;
    which = min(which / share, kOneMinusEpsilon);
    const LightChoice choice =
        pick_light(scene, params.settings.light_rule, s.point.position, s.normal, which);
    if (choice.probability > 0)
        connect_emitter<kFeatures>(params, choice, share, u, path, s, bsdf, wo, shadow);
}

/// What the emission of `hittable`, which the path met at `s`, counts for beside light sampling.
template <uint32_t kFeatures>
TP_HD Real emission_weight(const LaunchParams& params, const PathState& path, const Hit& hit,
                           const Hittable& hittable, const Surface& s) {
    const SceneView& scene = params.scene;
    if (!(path.bsdf_pdf > 0) || !params.settings.light_sampling || hittable.light == kNoLight)
        return 1;
    const uint32_t light = hittable.light + hit.primitive;
    const Real pdf =
        light_probability(scene, params.settings.light_rule, light, path.last, path.last_normal) *
        (1 - environment_share<kFeatures>(scene)) *
        emitter_pdf<kFeatures>(scene, hittable, hit, path.last, path.direction, s.point);
    return mis_weight(path.bsdf_pdf, pdf);
}

/// The integrators that end at the first surface.
template <uint32_t kFeatures>
TP_HD Vec3 first_hit_color(const LaunchParams& params, const Surface& s,
                           const MaterialRecord& material) {
    if (params.settings.integrator == IntegratorKind::Normal)
        return (s.normal + Vec3(1, 1, 1)) * Real(0.5);
    return albedo_of<kFeatures>(params.scene, material, s);
}

/// The channel of red, green, blue that a path has left beyond a surface that disperses light; -1:
/// all. The first such surface leaves one of them, for the rest of the path.
template <uint32_t kFeatures>
TP_HD int dispersed_channel(const LaunchParams& params, const Sampler& sampler,
                            const MaterialRecord& material, PathState& path) {
    if (!disperses<kFeatures>(params.scene, material)) return -1;
    const Real u = sample_1d<(kFeatures & kFeatureSobol) != 0>(sampler, kDimensionChannel);
    const int channel = min(static_cast<int>(3 * u), 2);
    if (!path.one_channel) {
        Vec3 left{0, 0, 0};
        left[channel] = 3 * path.throughput[channel];
        path.throughput = left;
        path.one_channel = true;
    }
    return channel;
}

/// Step 3: gathers what the path has met and chooses where it goes. Returns false where it ends;
/// `shadow` may be active either way.
template <uint32_t kFeatures>
TP_HD bool shade(const LaunchParams& params, const Sampler& sampler, const Hit& hit,
                 PathState& path, ShadowQuery& shadow) {
    constexpr bool kSobol = (kFeatures & kFeatureSobol) != 0;
    const SceneView& scene = params.scene;
    const PathSettings& settings = params.settings;

    // Beyond the scene.
    if (hit.index == kNoHit) {
        Real weight = 1;
        if (aims_at_environment<kFeatures>(scene) && path.bsdf_pdf > 0 && settings.light_sampling)
            weight = mis_weight(
                path.bsdf_pdf,
                scene.background.light_probability *
                    environment_pdf(scene.environment, scene.background, path.direction));
        const Vec3 radiance = path.depth == 1
                                  ? backdrop_radiance<kFeatures>(scene, path.direction)
                                  : background_radiance<kFeatures>(scene, path.direction);
        path.radiance += clamped(settings, path.depth, path.throughput * radiance * weight);
        return false;
    }
    const Hittable& hittable = scene.hittables[hit.index];
    const MaterialRecord& material = scene.materials[hittable.material];
    Surface s = make_surface<kFeatures>(scene, hittable, path.origin, path.direction, hit);
    if constexpr ((kFeatures & kFeaturePrincipled) != 0) {
        if (!s.front) path.throughput *= transmittance_within<kFeatures>(scene, material, hit.t);
    }
    const uint32_t dimension = vertex_dimension(path.vertex);
    const Vec4 color = surface_color<kFeatures>(scene, material, s);

    // Straight through, which is no scattering.
    if constexpr ((kFeatures & kFeatureOpacity) != 0) {
        const Real opacity = opacity_of(material, color.w);
        if (opacity < 1 && sample_1d<kSobol>(sampler, dimension + kDimensionOpacity) >= opacity) {
            path.throughput *= material.pass_through;
            const Real left = path.t_max - hit.t;
            leave_surface(path, s, path.direction);
            path.t_max = left;
            return path.vertex - path.depth < kMaxPassThrough;
        }
    }
    if constexpr ((kFeatures & kFeatureDebug) != 0) {
        if (settings.integrator == IntegratorKind::Normal ||
            settings.integrator == IntegratorKind::Flat) {
            path.radiance += path.throughput * first_hit_color<kFeatures>(params, s, material);
            return false;
        }
    }

    // Emission, weighed against light sampling.
    if constexpr ((kFeatures & kFeatureLights) != 0) {
        if (emits_towards(material, is_turned_inwards(hittable), s.front)) {
            const Vec3 radiance = emitted_radiance<kFeatures>(scene, material, s) *
                                  cone_share(material, dot(path.direction, s.point.normal));
            const Real weight = emission_weight<kFeatures>(params, path, hit, hittable, s);
            path.radiance += clamped(settings, path.depth, path.throughput * radiance * weight);
        }
    }
    if (material.kind == MaterialKind::DiffuseLight ||
        path.depth >= static_cast<uint32_t>(settings.max_depth))
        return false;

    // Direct light.
    if constexpr ((kFeatures & kFeatureMeshes) != 0) {
        if (settings.terminator_fix) lift_off_mesh<kFeatures>(scene, hittable, material, hit, s);
    }
    const int channel = dispersed_channel<kFeatures>(params, sampler, material, path);
    const Vec3 wo = -path.direction;
    const Bsdf bsdf =
        make_bsdf<kFeatures>(scene, material, Vec3(color), s, wo, settings.scatter, channel);
    if constexpr ((kFeatures & kFeatureLights) != 0) {
        const bool has_lights = !scene.lights.empty() || aims_at_environment<kFeatures>(scene);
        if (settings.light_sampling && has_lights && !is_specular(bsdf))
            sample_light<kFeatures>(params, sampler, path, s, bsdf, wo, shadow);
    }

    // The next direction.
    const Vec2 u = sample_2d<kSobol>(sampler, dimension + kDimensionBsdf);
    Real u3 = 0;
    if (samples_with_third_number(bsdf))
        u3 = sample_1d<kSobol>(sampler, dimension + kDimensionLobe);
    const BsdfSample next = bsdf_sample<kFeatures>(bsdf, wo, u, u3);
    if (is_black(next.weight)) return false;
    path.throughput *= next.weight;
    path.eta_scale *= next.eta_scale;
    path.bsdf_pdf = next.pdf;
    path.last = s.point.position;
    path.last_normal = s.normal;
    leave_surface(path, s, next.wi);

    // Russian roulette.
    if (settings.roulette_depth > 0 &&
        path.depth >= static_cast<uint32_t>(settings.roulette_depth)) {
        const Real survival = max_component(path.throughput) * path.eta_scale;
        if (survival < 1) {
            if (sample_1d<kSobol>(sampler, dimension + kDimensionRoulette) >= survival)
                return false;
            path.throughput /= survival;
        }
    }
    ++path.depth;
    return true;
}

/// Step 4: the share of light, per channel, that reaches along the query's segment.
template <uint32_t kFeatures>
TP_HD Vec3 transmittance(const LaunchParams& params, const ShadowQuery& shadow) {
    const SceneView& scene = params.scene;
    if constexpr ((kFeatures & kFeatureOpacity) == 0) {
        const bool blocked = is_blocked<kFeatures>(scene, shadow.origin, shadow.direction,
                                                   shadow.distance, shadow.ignored);
        return blocked ? Vec3(0, 0, 0) : Vec3(1, 1, 1);
    } else {
        // From surface to surface; each lets its share through.
        Vec3 share{1, 1, 1};
        Vec3 origin = shadow.origin;
        Real left = shadow.distance;
        for (uint32_t i = 0; i < kMaxPassThrough; ++i) {
            Hit hit;
            hit.t = left;
            if (!traverse<kFeatures, false>(scene, origin, shadow.direction, shadow.ignored, hit))
                return share;
            const Hittable& hittable = scene.hittables[hit.index];
            const MaterialRecord& material = scene.materials[hittable.material];
            const Surface s =
                make_surface<kFeatures>(scene, hittable, origin, shadow.direction, hit);
            const Real opacity =
                opacity_of(material, surface_color<kFeatures>(scene, material, s).w);
            share *= material.pass_through * (1 - min(opacity, Real(1)));
            if (is_black(share)) break;
            origin = offset_ray_origin(s.point.position, s.point.error, s.point.normal,
                                       shadow.direction);
            left -= hit.t;
        }
        return {0, 0, 0};
    }
}

/// Step 4: adds the light of an active query.
template <uint32_t kFeatures>
TP_HD void connect_to_light(const LaunchParams& params, const ShadowQuery& shadow,
                            PathState& path) {
    if (shadow.is_active)
        path.radiance += shadow.contribution * transmittance<kFeatures>(params, shadow);
}

/// Step 5: the path's radiance, black if it does not fit the film; then `is_valid` is false.
TP_HD Vec3 finish_path(const PathState& path, bool& is_valid) {
    is_valid = fits_film(path.radiance);
    return is_valid ? path.radiance : Vec3(0, 0, 0);
}

}  // namespace tp
