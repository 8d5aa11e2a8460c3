// Lambertian reflection: f = albedo / pi on the side of wo.
#pragma once

#include <teapath/kernel/bsdf/bsdf_sample.h>
#include <teapath/kernel/kinds.h>

namespace tp {

/// f(wo, wi) |cos(wi)|.
TP_HD Vec3 lambertian_eval(Vec3 albedo, Vec3 normal, Vec3 wi) {
    return albedo * (max(dot(normal, wi), Real(0)) * kInvPi);
}

TP_HD Real lambertian_pdf(Vec3 normal, Vec3 wi) {
    return max(dot(normal, wi), Real(0)) * kInvPi;
}

TP_HD BsdfSample lambertian_sample(Vec3 albedo, Vec3 normal, Vec2 u) {
    const Vec3 local = sample_cosine_hemisphere(u);
    return {frame_around(normal).to_world(local), albedo, local.z * kInvPi, 1};
}

/// The other rules that programs of the field scatter by, for comparison in the Book integrator:
/// weight is the albedo whatever the density, as these programs have it.
TP_HD BsdfSample lambertian_sample_by_rule(ScatterRule rule, Vec3 albedo, Vec3 normal, Vec2 u,
                                           Real u3) {
    if (rule == ScatterRule::Cosine) return lambertian_sample(albedo, normal, u);
    if (rule == ScatterRule::Hemisphere) {
        const Vec3 local = sample_uniform_hemisphere(u);
        return {frame_around(normal).to_world(local), albedo, uniform_hemisphere_pdf(), 1};
    }
    // Normal plus a point in the unit ball: density proportional to cos^3.
    const Vec3 d = normal + sample_uniform_ball(u, u3);
    const Real l2 = length_squared(d);
    return {l2 > Real(1e-12) ? d * tp::rsqrt(l2) : normal, albedo, 0, 1};
}

}  // namespace tp
