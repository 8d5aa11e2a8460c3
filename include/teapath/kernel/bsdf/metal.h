// The metal of Ray Tracing in One Weekend: mirror reflection plus a point in a ball of radius
// `fuzz`; what ends below the surface is absorbed. The density over solid angle has a closed form
// (warps.h), so that light sampling and multiple importance sampling work. Not reciprocal near
// grazing angles, by its construction.
#pragma once

#include <teapath/kernel/bsdf/bsdf_sample.h>

namespace tp {

TP_HD Vec3 reflect(Vec3 wo, Vec3 normal) {
    return normal * (2 * dot(wo, normal)) - wo;
}

TP_HD Real metal_pdf(Real fuzz, Vec3 normal, Vec3 wo, Vec3 wi) {
    return fuzz > 0 && dot(normal, wi) > 0 ? fuzz_lobe_pdf(reflect(wo, normal), fuzz, wi) : 0;
}

/// f(wo, wi) |cos(wi)|.
TP_HD Vec3 metal_eval(Vec3 reflectance, Real fuzz, Vec3 normal, Vec3 wo, Vec3 wi) {
    return reflectance * metal_pdf(fuzz, normal, wo, wi);
}

TP_HD BsdfSample metal_sample(Vec3 reflectance, Real fuzz, Vec3 normal, Vec3 wo, Vec2 u, Real u3) {
    const Vec3 mirrored = reflect(wo, normal);
    if (fuzz <= 0) return {mirrored, reflectance, 0, 1};
    const Vec3 wi = sample_fuzz_lobe(mirrored, fuzz, u, u3);
    if (dot(normal, wi) <= 0) return {};
    return {wi, reflectance, fuzz_lobe_pdf(mirrored, fuzz, wi), 1};
}

}  // namespace tp
