// The principled surface: a base of metal and dielectric after glTF 2.0, appendix B (diffuse under
// a Fresnel layer, or transmitting), under a coat, under sheen. With `compensation` no lobe and no
// mix of them loses energy: what microfacets lose at one scattering is given back (albedo_table.h),
// and each layer leaves what it does not reflect to those below; without, it is appendix B as it
// stands. Directions are in the local frame of the shading normal, wo above.
#pragma once

#include <teapath/core/color.h>
#include <teapath/core/frame.h>
#include <teapath/kernel/bsdf/albedo_table.h>
#include <teapath/kernel/bsdf/dielectric.h>
#include <teapath/kernel/bsdf/rough_dielectric.h>
#include <teapath/kernel/bsdf/sheen.h>
#include <teapath/kernel/bsdf/thin_film.h>

namespace tp {

/// The surface's parameters at a point, textures looked up.
struct PrincipledParameters {
    Vec3 base{Real(0.5), Real(0.5), Real(0.5)};
    Real metallic = 0;
    GgxAlpha alpha{Real(0.25), Real(0.25)};
    Vec3 f0{Real(0.04), Real(0.04), Real(0.04)};  // of the dielectric, seen straight on
    Real f90 = 1;                                 // at grazing
    Real eta = Real(1.5);  // index beyond the surface over the index on the side of wo
    Real transmission = 0;
    Real diffuse_transmission = 0;
    Vec3 diffuse_transmission_color{1, 1, 1};
    Real coat = 0;
    Real coat_alpha = kLeastAlpha;
    Vec3 coat_normal{0, 0, 1};  // unit, in the local frame
    Real film = 0;              // how much of a thin film there is between base and coat
    Real film_ior = Real(1.3);
    Real film_thickness = 400;  // nanometres
    Vec3 sheen{0, 0, 0};
    Real sheen_alpha = Real(0.25);
    bool thin = true;
    bool compensation = true;
};

/// The parameters with what follows from them for one wo.
struct PrincipledLobes {
    PrincipledParameters p;  // f0 with the film's colours
    Vec3 metal_f0;           // of the metal, seen straight on
    Real mean_alpha;         // of both directions
    Vec3 dielectric_ms;      // reflectance of what facets scatter on, of the dielectric
    Vec3 multiple;           // the same, with the metal
    Real lost_o;             // 1 - E(wo): what one scattering loses of white
    Real lost_average;       // its average
    Real under_o;            // what the dielectric's reflection leaves below, seen from wo
    Real under_average;
    Real below_coat;      // what sheen and coat leave to the base
    Real below_sheen;     // what sheen leaves to the coat
    Real interface_gain;  // of the transmitting part
    // How likely each lobe is sampled.
    Real coat, sheen, specular, diffuse, diffuse_transmission, transmission;
};

inline constexpr Real kCoatF0 = Real(0.04);  // of a coat with index 1.5

TP_HD Real schlick_weight(Real cosine) {
    const Real m = clamp(1 - cosine, Real(0), Real(1));
    return sqr(m * m) * m;
}

/// The share of the way from f0 to f90 that a dielectric's reflectance has gone: exact for the
/// transmitting part, where total reflection matters.
TP_HD Real exact_weight(Real cosine, Real eta) {
    const Real f0 = sqr((eta - 1) / (eta + 1));
    return (fresnel_dielectric(min(cosine, Real(1)), eta) - f0) / (1 - f0);
}

TP_HD Vec3 dielectric_reflectance(const PrincipledParameters& p, Real weight) {
    return p.f0 + (Vec3(p.f90, p.f90, p.f90) - p.f0) * weight;
}
TP_HD Real transmitting_weight(const PrincipledParameters& p, Real cosine) {
    return p.thin ? schlick_weight(cosine) : exact_weight(cosine, p.eta);
}

/// What reflectance becomes after all further scatterings among facets, by its average.
TP_HD Vec3 multiple_reflectance(Vec3 f0, Real f90, Real albedo_average) {
    const Vec3 average = f0 + (Vec3(f90, f90, f90) - f0) * Real(1.0 / 21);
    const Real lost = 1 - albedo_average;
    return average * average * albedo_average / (Vec3(1, 1, 1) - average * lost);
}

/// What the dielectric's layer leaves below it from a direction with this table entry.
TP_HD Real left_below(const PrincipledLobes& l, Vec2 albedo) {
    const PrincipledParameters& p = l.p;
    const Vec3 reflected = p.f0 * albedo.x + Vec3(p.f90, p.f90, p.f90) * albedo.y +
                           l.dielectric_ms * (1 - albedo.x - albedo.y);
    return max(1 - max_component(reflected), Real(0));
}

/// How likely each lobe is sampled: by what it gives back of light from everywhere, about.
TP_HD void choose_lobes(PrincipledLobes& l, Vec2 albedo, Real cos_o) {
    const PrincipledParameters& p = l.p;
    const Vec3 white{1, 1, 1};
    const Vec3 dielectric = p.f0 * albedo.x + white * (p.f90 * albedo.y);
    const Vec3 metal = l.metal_f0 * albedo.x + white * albedo.y;
    // Rough facets let light through also where a smooth interface would reflect all of it.
    const Real smooth =
        1 - min(luminance(dielectric_reflectance(p, transmitting_weight(p, cos_o))), Real(1));
    const Real seen_through =
        p.transmission * (1 - p.metallic) * max(smooth, min(2 * l.mean_alpha, Real(0.5)));
    const Real mirror = luminance(lerp(dielectric, metal, p.metallic));
    const Real opaque = (1 - p.metallic) * (1 - p.transmission) * l.under_o;
    l.specular = max(mirror, (1 - p.metallic) * p.transmission * (1 - seen_through) * Real(0.5));
    l.diffuse = opaque * (1 - p.diffuse_transmission) * luminance(p.base) +
                (p.compensation ? luminance(l.multiple) * l.lost_o : 0);
    l.diffuse_transmission =
        opaque * p.diffuse_transmission * luminance(p.diffuse_transmission_color);
    l.transmission = seen_through * luminance(p.base);
    const Real sum = l.specular + l.diffuse + l.diffuse_transmission + l.transmission;
    const Real scale = sum > 0 ? (1 - l.coat - l.sheen) / sum : 0;
    l.specular = sum > 0 ? l.specular * scale : 1 - l.coat - l.sheen;
    l.diffuse *= scale;
    l.diffuse_transmission *= scale;
    l.transmission *= scale;
}

/// Gives dielectric and metal the colours of the film as it is seen from wo. They go into what the
/// lobes reflect straight on, so that all that is made from it, and the energy, follow; a facet is
/// coloured as the whole surface is, which for smooth ones is exact.
TP_HD void add_film(PrincipledLobes& l, Real cos_o) {
    PrincipledParameters& p = l.p;
    const Vec3 on_dielectric =
        straight_on(film_reflectance(cos_o, p.film_ior, p.film_thickness, p.f0), cos_o);
    const Vec3 on_metal =
        straight_on(film_reflectance(cos_o, p.film_ior, p.film_thickness, p.base), cos_o);
    p.f0 = lerp(p.f0, on_dielectric, p.film);
    l.metal_f0 = lerp(p.base, on_metal, p.film);
}

/// A direction of the local frame in that of the coat.
TP_HD Vec3 to_coat(const PrincipledParameters& p, Vec3 w) {
    if (p.coat_normal.z >= 1) return w;
    return frame_around(p.coat_normal).to_local(w);
}

/// Prepares the lobes for a direction wo above.
TP_HD PrincipledLobes make_principled(const PrincipledParameters& parameters,
                                      const AlbedoTables& tables, Vec3 wo) {
    const Real cos_o = wo.z;
    PrincipledLobes l;
    l.p = parameters;
    l.metal_f0 = parameters.base;
    if (parameters.film > 0) add_film(l, cos_o);
    const PrincipledParameters& p = l.p;
    l.mean_alpha = tp::sqrt(p.alpha.x * p.alpha.y);
    const Vec2 albedo = ggx_albedo(tables, cos_o, l.mean_alpha);
    const Vec2 average = ggx_average_albedo(tables, l.mean_alpha);
    const Real average_sum = average.x + average.y;
    l.lost_o = max(1 - albedo.x - albedo.y, Real(0));
    l.lost_average = max(1 - average_sum, Real(1e-6));
    l.dielectric_ms = p.compensation ? multiple_reflectance(p.f0, p.f90, average_sum) : Vec3(0);
    l.multiple = lerp(l.dielectric_ms * (1 - p.transmission),
                      multiple_reflectance(l.metal_f0, 1, average_sum), p.metallic);
    l.under_o = left_below(l, albedo);
    l.under_average = max(left_below(l, average), Real(1e-6));

    // The layers above.
    Real sheen_o = 0, coat_o = 0;
    if (!is_black(p.sheen)) sheen_o = min(sheen_albedo(tables, cos_o, p.sheen_alpha), Real(1));
    l.below_sheen = 1 - max_component(p.sheen) * sheen_o;
    if (p.coat > 0) {
        const Real cos_coat = max(to_coat(p, wo).z, Real(1e-4));
        const Vec2 coat = ggx_albedo(tables, cos_coat, p.coat_alpha);
        coat_o = p.coat * (p.compensation ? kCoatF0 * coat.x + coat.y
                                          : kCoatF0 + (1 - kCoatF0) * schlick_weight(cos_coat));
    }
    l.below_coat = l.below_sheen * (1 - coat_o);
    l.sheen = 1 - l.below_sheen;
    l.coat = l.below_sheen * coat_o;

    // The transmitting interface, with what one scattering loses.
    l.interface_gain = 1;
    if (p.compensation && p.transmission > 0) {
        const Real kept =
            p.thin ? albedo.x + albedo.y : glass_albedo(tables, cos_o, l.mean_alpha, p.eta);
        l.interface_gain = 1 / max(kept, Real(0.1));
    }
    choose_lobes(l, albedo, cos_o);
    return l;
}

/// What reflects about the facet `h`: colour of one scattering.
TP_HD Vec3 specular_color(const PrincipledLobes& l, Real cos_h) {
    const PrincipledParameters& p = l.p;
    const Real schlick = schlick_weight(cos_h);
    Vec3 color = dielectric_reflectance(p, schlick);
    if (p.transmission > 0)
        color =
            lerp(color, dielectric_reflectance(p, transmitting_weight(p, cos_h)) * l.interface_gain,
                 p.transmission);
    if (p.metallic > 0)
        color = lerp(color, l.metal_f0 + (Vec3(1, 1, 1) - l.metal_f0) * schlick, p.metallic);
    return color;
}

/// What is refracted or goes through, of light of 1.
TP_HD Vec3 transmission_color(const PrincipledLobes& l, Real cos_h) {
    const PrincipledParameters& p = l.p;
    const Vec3 reflected = dielectric_reflectance(p, transmitting_weight(p, cos_h));
    const Real left = max(1 - max_component(reflected), Real(0));
    return p.base * (left * l.interface_gain * p.transmission * (1 - p.metallic));
}

/// What the coat reflects of light: f |cos(wi)|.
TP_HD Real coat_reflection(const PrincipledParameters& p, Vec3 wo, Vec3 wi) {
    const Vec3 o = to_coat(p, wo), i = to_coat(p, wi);
    if (!(o.z > 0 && i.z > 0)) return 0;
    const Vec3 h = normalize(o + i);
    const Real fresnel = kCoatF0 + (1 - kCoatF0) * schlick_weight(dot(o, h));
    return fresnel * ggx_reflection({p.coat_alpha, p.coat_alpha}, o, i, h, true);
}

TP_HD Real coat_pdf(const PrincipledParameters& p, Vec3 wo, Vec3 wi) {
    const Vec3 o = to_coat(p, wo), i = to_coat(p, wi);
    if (!(o.z > 0 && i.z > 0)) return 0;
    return ggx_reflection_pdf({p.coat_alpha, p.coat_alpha}, o, normalize(o + i));
}

TP_HD Vec3 sample_coat(const PrincipledParameters& p, Vec3 wo, Vec2 u) {
    const Vec3 o = to_coat(p, wo);
    if (!(o.z > 0)) return {0, 0, 0};
    const Vec3 wi = reflect(o, sample_ggx_normal({p.coat_alpha, p.coat_alpha}, o, u));
    if (!(wi.z > 0)) return {0, 0, 0};
    return p.coat_normal.z >= 1 ? wi : frame_around(p.coat_normal).to_world(wi);
}

/// Reflection into wi, above: f |cos(wi)|.
TP_HD Vec3 principled_reflection(const PrincipledLobes& l, const AlbedoTables& tables, Vec3 wo,
                                 Vec3 wi) {
    const PrincipledParameters& p = l.p;
    const Vec3 h = normalize(wo + wi);
    const Real cos_h = dot(wo, h);
    Vec3 sum = specular_color(l, cos_h) * ggx_reflection(p.alpha, wo, wi, h, true);

    // Diffuse under the dielectric's layer, which light passes twice.
    const Real opaque = (1 - p.metallic) * (1 - p.transmission) * (1 - p.diffuse_transmission);
    Vec3 passed;
    if (p.compensation) {
        const Vec2 albedo = ggx_albedo(tables, wi.z, l.mean_alpha);
        passed = Vec3(l.under_o * left_below(l, albedo) / l.under_average);
        const Real lost_i = max(1 - albedo.x - albedo.y, Real(0));
        sum += l.multiple * (l.lost_o * lost_i / l.lost_average * kInvPi * wi.z);
    } else {
        passed = Vec3(1, 1, 1) - specular_color(l, cos_h);
    }
    sum += p.base * passed * (opaque * kInvPi * wi.z);

    // The layers above.
    sum *= l.below_coat;
    if (p.coat > 0) {
        sum += Vec3(p.coat * l.below_sheen * coat_reflection(p, wo, wi));
    }
    if (!is_black(p.sheen)) sum += p.sheen * sheen_reflection(p.sheen_alpha, wo, wi);
    return sum;
}

/// Transmission into wi, below: f |cos(wi)|.
TP_HD Vec3 principled_transmission(const PrincipledLobes& l, const AlbedoTables& tables, Vec3 wo,
                                   Vec3 wi) {
    const PrincipledParameters& p = l.p;
    Vec3 sum{0, 0, 0};
    if (p.transmission > 0 && p.thin) {
        const Vec3 mirrored{wi.x, wi.y, -wi.z};
        const Vec3 h = normalize(wo + mirrored);
        sum += transmission_color(l, dot(wo, h)) * ggx_reflection(p.alpha, wo, mirrored, h, true);
    } else if (p.transmission > 0) {
        const Vec3 h = refraction_normal(wo, wi, p.eta);
        if (h.z > 0)
            sum += transmission_color(l, dot(wo, h)) *
                   ggx_refraction(p.alpha, wo, wi, h, p.eta, false);
    }
    const Real leaf = (1 - p.metallic) * (1 - p.transmission) * p.diffuse_transmission;
    if (leaf > 0) {
        Real passed = l.under_o;
        if (p.compensation)
            passed *= left_below(l, ggx_albedo(tables, -wi.z, l.mean_alpha)) / l.under_average;
        sum += p.diffuse_transmission_color * (leaf * passed * kInvPi * -wi.z);
    }
    return sum * l.below_coat;
}

/// f(wo, wi) |cos(wi)|.
TP_HD Vec3 principled_eval(const PrincipledLobes& l, const AlbedoTables& tables, Vec3 wo, Vec3 wi) {
    if (wi.z > 0) return principled_reflection(l, tables, wo, wi);
    return wi.z < 0 ? principled_transmission(l, tables, wo, wi) : Vec3(0, 0, 0);
}

/// Density of principled_sample over solid angle.
TP_HD Real principled_pdf(const PrincipledLobes& l, Vec3 wo, Vec3 wi) {
    const PrincipledParameters& p = l.p;
    if (wi.z > 0) {
        const Vec3 h = normalize(wo + wi);
        Real pdf = (l.diffuse + l.sheen) * kInvPi * wi.z;
        pdf += l.specular * ggx_reflection_pdf(p.alpha, wo, h);
        if (l.coat > 0) pdf += l.coat * coat_pdf(p, wo, wi);
        return pdf;
    }
    Real pdf = l.diffuse_transmission * kInvPi * -wi.z;
    if (l.transmission > 0 && p.thin) {
        const Vec3 h = normalize(wo + Vec3(wi.x, wi.y, -wi.z));
        pdf += l.transmission * ggx_reflection_pdf(p.alpha, wo, h);
    } else if (l.transmission > 0) {
        const Vec3 h = refraction_normal(wo, wi, p.eta);
        if (h.z > 0) pdf += l.transmission * refraction_pdf(p.alpha, wo, wi, h, p.eta);
    }
    return pdf;
}

/// A direction of one of the lobes, picked by `choice` in [0, 1); false where none is found.
TP_HD bool principled_direction(const PrincipledLobes& l, Vec3 wo, Vec2 u, Real choice, Vec3& wi) {
    const PrincipledParameters& p = l.p;
    choice -= l.specular;
    if (choice < 0) {
        wi = reflect(wo, sample_ggx_normal(p.alpha, wo, u));
        return wi.z > 0;
    }
    choice -= l.transmission;
    if (choice < 0) {
        const Vec3 h = sample_ggx_normal(p.alpha, wo, u);
        if (!p.thin) return refract(wo, h, p.eta, wi) && wi.z < 0;
        wi = reflect(wo, h);
        wi.z = -wi.z;
        return wi.z < 0;
    }
    choice -= l.coat;
    if (choice < 0) {
        wi = sample_coat(p, wo, u);
        return wi.z > 0;
    }
    wi = sample_cosine_hemisphere(u);
    choice -= l.diffuse_transmission;
    if (choice < 0) wi.z = -wi.z;
    return wi.z != 0;
}

/// The BsdfSample, in the local frame.
TP_HD BsdfSample principled_sample(const PrincipledLobes& l, const AlbedoTables& tables, Vec3 wo,
                                   Vec2 u, Real choice) {
    BsdfSample sample;
    if (!principled_direction(l, wo, u, choice, sample.wi)) return {};
    sample.pdf = principled_pdf(l, wo, sample.wi);
    if (!(sample.pdf > 0)) return {};
    sample.weight = principled_eval(l, tables, wo, sample.wi) / sample.pdf;
    if (sample.wi.z < 0 && !l.p.thin && l.p.transmission > 0) sample.eta_scale = sqr(l.p.eta);
    return sample;
}

}  // namespace tp
