// The colours of a thin film on a surface: KHR_materials_iridescence, after Belcour and Barla, "A
// Practical Extension to Microfacet Theory for the Modeling of Varying Iridescence", 2017.
#pragma once

#include <teapath/core/math.h>

namespace tp {

/// The response of the eye, as linear sRGB, to light whose phase turns once over `path` nanometres
/// and is shifted by `shift` radians: the Fourier transform of the colour matching functions, which
/// are fitted by Gaussians (Belcour and Barla, equation 10).
TP_HD Vec3 film_sensitivity(Real path, Vec3 shift) {
    const Real phase = 2 * kPi * path * Real(1e-9);
    const Vec3 value{Real(5.4856e-13), Real(4.4201e-13), Real(5.2481e-13)};
    const Vec3 position{Real(1.6810e6), Real(1.7953e6), Real(2.2084e6)};
    const Vec3 variance{Real(4.3278e9), Real(9.3046e9), Real(6.6121e9)};
    const Real phase2 = phase * phase;
    Vec3 xyz{0, 0, 0};
    for (int i = 0; i < 3; ++i)
        xyz[i] = value[i] * tp::sqrt(2 * kPi * variance[i]) *
                 std::cos(position[i] * phase + shift[i]) * std::exp(-phase2 * variance[i]);
    xyz.x += Real(9.7470e-14) * tp::sqrt(2 * kPi * Real(4.5282e9)) *
             std::cos(Real(2.2399e6) * phase + shift.x) * std::exp(Real(-4.5282e9) * phase2);
    xyz = xyz / Real(1.0685e-7);
    return {Real(3.2404542) * xyz.x - Real(1.5371385) * xyz.y - Real(0.4985314) * xyz.z,
            Real(-0.9692660) * xyz.x + Real(1.8760108) * xyz.y + Real(0.0415560) * xyz.z,
            Real(0.0556434) * xyz.x - Real(0.2040259) * xyz.y + Real(1.0572252) * xyz.z};
}

/// Reflectance straight on between two indices of refraction.
TP_HD Real f0_between(Real inside, Real outside) {
    return sqr((inside - outside) / (inside + outside));
}

TP_HD Real schlick(Real f0, Real cosine) {
    const Real m = clamp(1 - cosine, Real(0), Real(1));
    return f0 + (1 - f0) * sqr(m * m) * m;
}

/// Reflectance, 0 to 1, of a film with index `film_ior` and that thickness in nanometres, seen from
/// air at `cosine`, on a base that reflects `base_f0` straight on.
TP_HD Vec3 film_reflectance(Real cosine, Real film_ior, Real thickness, Vec3 base_f0) {
    // A film that vanishes has the index of the air.
    const Real edge = clamp(thickness / Real(0.03), Real(0), Real(1));
    const Real ior = lerp(Real(1), film_ior, edge * edge * (3 - 2 * edge));
    const Real sin2 = (1 - sqr(cosine)) / sqr(ior);
    if (sin2 > 1) return {1, 1, 1};
    const Real cos_film = tp::sqrt(1 - sin2);

    // The outer interface and the inner one, with the phases that they shift.
    const Real outer = schlick(f0_between(ior, 1), cosine);
    const Real passed = 1 - outer;
    const Real outer_shift = ior < 1 ? Real(0) : kPi;
    const Real path = 2 * ior * thickness * cos_film;
    Vec3 inner{0, 0, 0}, shift{0, 0, 0};
    for (int i = 0; i < 3; ++i) {
        const Real root = tp::sqrt(clamp(base_f0[i], Real(0), Real(0.9999)));
        const Real base_ior = (1 + root) / (1 - root);
        inner[i] = schlick(f0_between(base_ior, ior), cos_film);
        shift[i] = outer_shift + (base_ior < ior ? kPi : Real(0));
    }

    // The series of reflections within the film; two terms are enough for the eye.
    const Vec3 both = min(inner * outer, Vec3(Real(0.9999)));
    const Vec3 root{tp::sqrt(both.x), tp::sqrt(both.y), tp::sqrt(both.z)};
    const Vec3 all = inner * sqr(passed) / (Vec3(1, 1, 1) - both);
    Vec3 sum = all + Vec3(outer);
    Vec3 term = all - Vec3(passed);
    for (int m = 1; m <= 2; ++m) {
        term *= root;
        const auto order = static_cast<Real>(m);
        sum += term * Real(2) * film_sensitivity(order * path, shift * order);
    }
    return min(max(sum, Vec3(0, 0, 0)), Vec3(1, 1, 1));
}

/// What Schlick's reflectance is straight on if it is `reflectance` at `cosine`, at least 0.
TP_HD Vec3 straight_on(Vec3 reflectance, Real cosine) {
    const Real weight = min(schlick(0, cosine), Real(0.9999));
    return max((reflectance - Vec3(weight)) / (1 - weight), Vec3(0, 0, 0));
}

}  // namespace tp
