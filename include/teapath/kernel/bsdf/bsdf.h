// The bsdf of a surface point: a tag and the parameters of one lobe model, with one switch per
// operation. A new material is a file beside this one, a case in each switch here and in
// material.h, a row in the enum table, a test. kFeatures leaves out the kinds that a scene has not.
#pragma once

#include <teapath/kernel/bsdf/conductor.h>
#include <teapath/kernel/bsdf/dielectric.h>
#include <teapath/kernel/bsdf/lambertian.h>
#include <teapath/kernel/bsdf/metal.h>
#include <teapath/kernel/bsdf/principled.h>
#include <teapath/kernel/scene_features.h>

namespace tp {

/// A direction in the frame of a shading normal; one that should be above does not graze.
TP_HD Vec3 local_wo(const Frame& frame, Vec3 wo) {
    const Vec3 local = frame.to_local(wo);
    return {local.x, local.y, max(local.z, Real(1e-4))};
}

/// The lobes of a principled surface in the world.
struct PlacedLobes {
    PrincipledLobes lobes;
    Frame frame;  // z is the shading normal
    AlbedoTables tables;

    TP_HD_MEMBER Vec3 local_wo(Vec3 wo) const { return tp::local_wo(frame, wo); }
};

/// The facets of a conductor, or of a rough dielectric.
struct PlacedFacets {
    Frame frame;      // z is the shading normal
    Real alpha;       // width of GGX; 0 is smooth
    bool correlated;  // masking
    Vec3 gain;        // times the tint: what makes up for multiple scattering
    Vec3 eta, k;      // Conductor
};

struct Bsdf {
    MaterialKind kind;
    FresnelRule fresnel;
    ScatterRule scatter;
    Vec3 color;             // albedo, reflectance or tint
    Vec3 normal;            // unit, on the side of wo
    Real fuzz;              // Metal
    Real eta;               // Dielectric: index on the far side over index on the side of wo
    bool is_rough = false;  // Dielectric, Conductor
    union {
        PlacedLobes principled;  // Principled
        PlacedFacets facets;     // Conductor; Dielectric where it is_rough
    };

    TP_HD_MEMBER Bsdf() {}
};

/// True if every lobe is a delta: light sampling finds nothing.
TP_HD bool is_specular(const Bsdf& b) {
    switch (b.kind) {
        case MaterialKind::Metal: return b.fuzz <= 0;
        case MaterialKind::Dielectric:
        case MaterialKind::Conductor: return !b.is_rough;
        case MaterialKind::Lambertian:
        case MaterialKind::DiffuseLight:
        case MaterialKind::Principled: break;
    }
    return false;
}

/// True if bsdf_sample reads its third number; it is 0 otherwise, which saves making it.
TP_HD bool samples_with_third_number(const Bsdf& b) {
    switch (b.kind) {
        case MaterialKind::Lambertian: return b.scatter == ScatterRule::CosineCubed;
        case MaterialKind::Metal: return b.fuzz > 0;
        case MaterialKind::Principled: return true;
        case MaterialKind::Dielectric: return b.is_rough;
        case MaterialKind::Conductor:
        case MaterialKind::DiffuseLight: break;
    }
    return false;
}

/// The operations on facets: a rough dielectric, or a conductor.
TP_HD Vec3 facets_eval(const Bsdf& b, Vec3 wo, Vec3 wi) {
    const PlacedFacets& f = b.facets;
    const Vec3 o = local_wo(f.frame, wo), i = f.frame.to_local(wi);
    const Vec3 tint = b.color * f.gain;
    if (b.kind == MaterialKind::Conductor)
        return conductor_eval(f.eta, f.k, tint, f.alpha, f.correlated, o, i);
    return tint * rough_dielectric_eval(b.fresnel, b.eta, f.alpha, f.correlated, o, i);
}

TP_HD Real facets_pdf(const Bsdf& b, Vec3 wo, Vec3 wi) {
    const PlacedFacets& f = b.facets;
    const Vec3 o = local_wo(f.frame, wo), i = f.frame.to_local(wi);
    return b.kind == MaterialKind::Conductor
               ? conductor_pdf(f.alpha, o, i)
               : rough_dielectric_pdf(b.fresnel, b.eta, f.alpha, o, i);
}

TP_HD BsdfSample facets_sample(const Bsdf& b, Vec3 wo, Vec2 u, Real u3) {
    const PlacedFacets& f = b.facets;
    const Vec3 o = local_wo(f.frame, wo), tint = b.color * f.gain;
    BsdfSample s;
    if (b.kind == MaterialKind::Conductor) {
        s = conductor_sample(f.eta, f.k, tint, f.alpha, f.correlated, o, u);
    } else {
        s = rough_dielectric_sample(b.fresnel, b.eta, f.alpha, f.correlated, o, u, u3);
        s.weight *= tint;
    }
    s.wi = f.frame.to_world(s.wi);
    return s;
}

/// f(wo, wi) |cos(wi)|, without delta lobes.
template <uint32_t kFeatures = kFeatureAll>
TP_HD Vec3 bsdf_eval(const Bsdf& b, Vec3 wo, Vec3 wi) {
    switch (b.kind) {
        case MaterialKind::Lambertian: return lambertian_eval(b.color, b.normal, wi);
        case MaterialKind::Metal: return metal_eval(b.color, b.fuzz, b.normal, wo, wi);
        case MaterialKind::Principled:
            if constexpr ((kFeatures & kFeaturePrincipled) != 0)
                return principled_eval(b.principled.lobes, b.principled.tables,
                                       b.principled.local_wo(wo), b.principled.frame.to_local(wi));
            break;
        case MaterialKind::Dielectric:
        case MaterialKind::Conductor:
            if constexpr ((kFeatures & kFeaturePrincipled) != 0)
                if (b.is_rough) return facets_eval(b, wo, wi);
            break;
        case MaterialKind::DiffuseLight: break;
    }
    return {0, 0, 0};
}

/// Density of bsdf_sample over solid angle, without delta lobes.
template <uint32_t kFeatures = kFeatureAll>
TP_HD Real bsdf_pdf(const Bsdf& b, Vec3 wo, Vec3 wi) {
    switch (b.kind) {
        case MaterialKind::Lambertian: return lambertian_pdf(b.normal, wi);
        case MaterialKind::Metal: return metal_pdf(b.fuzz, b.normal, wo, wi);
        case MaterialKind::Principled:
            if constexpr ((kFeatures & kFeaturePrincipled) != 0)
                return principled_pdf(b.principled.lobes, b.principled.local_wo(wo),
                                      b.principled.frame.to_local(wi));
            break;
        case MaterialKind::Dielectric:
        case MaterialKind::Conductor:
            if constexpr ((kFeatures & kFeaturePrincipled) != 0)
                if (b.is_rough) return facets_pdf(b, wo, wi);
            break;
        case MaterialKind::DiffuseLight: break;
    }
    return 0;
}

/// A direction with density bsdf_pdf, or of a delta lobe; `u` and `u3` are uniform in [0, 1).
template <uint32_t kFeatures = kFeatureAll>
TP_HD BsdfSample bsdf_sample(const Bsdf& b, Vec3 wo, Vec2 u, Real u3) {
    switch (b.kind) {
        case MaterialKind::Lambertian:
            return lambertian_sample_by_rule(b.scatter, b.color, b.normal, u, u3);
        case MaterialKind::Metal: return metal_sample(b.color, b.fuzz, b.normal, wo, u, u3);
        case MaterialKind::Conductor:
            if constexpr ((kFeatures & kFeaturePrincipled) != 0) return facets_sample(b, wo, u, u3);
            break;
        case MaterialKind::Dielectric:
            if constexpr ((kFeatures & kFeaturePrincipled) != 0)
                if (b.is_rough) return facets_sample(b, wo, u, u3);
            return dielectric_sample(b.color, b.eta, b.fresnel, b.normal, wo, u.x);
        case MaterialKind::Principled:
            if constexpr ((kFeatures & kFeaturePrincipled) != 0) {
                const PlacedLobes& p = b.principled;
                BsdfSample s = principled_sample(p.lobes, p.tables, p.local_wo(wo), u, u3);
                s.wi = p.frame.to_world(s.wi);
                return s;
            }
            break;
        case MaterialKind::DiffuseLight: break;
    }
    return {};
}

}  // namespace tp
