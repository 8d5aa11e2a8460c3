#include <teapath/core/parallel.h>
#include <teapath/device/albedo_arrays.h>
#include <teapath/kernel/bsdf/principled.h>

#include <algorithm>

namespace tp {
namespace {

constexpr int kSamples = 1024;
constexpr int kGlassSamples = 400;
constexpr Real kLeastCosine = Real(2e-3);  // stands for grazing

// Points that fill the unit square evenly: multiples of the plastic number's inverses (Roberts,
// "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
Vec2 square_point(int i) {
    const double x = 0.5 + i * 0.75487766624669276, y = 0.5 + i * 0.56984029099805327;
    return {static_cast<Real>(x - std::floor(x)), static_cast<Real>(y - std::floor(y))};
}

Real node_value(int node, int nodes) {
    return static_cast<Real>(node) / static_cast<Real>(nodes - 1);
}
Real node_alpha(int node, int nodes) {
    return std::max(sqr(node_value(node, nodes)), kLeastAlpha);
}
Vec3 direction_of(Real cosine) {
    const Real z = std::max(cosine, kLeastCosine);
    return {safe_sqrt(1 - z * z), 0, z};
}

// x and y: what multiplies f0 and f90 of Schlick's approximation.
Vec2 integrate_ggx(Real alpha, Real cosine) {
    const GgxAlpha a{alpha, alpha};
    const Vec3 wo = direction_of(cosine);
    double f0 = 0, f90 = 0;
    for (int i = 0; i < kSamples; ++i) {
        const Vec3 h = sample_ggx_normal(a, wo, square_point(i));
        const Vec3 wi = reflect(wo, h);
        if (wi.z <= 0) continue;
        const double kept = static_cast<double>(ggx_masking(a, wo, wi, true) / ggx_masking(a, wo));
        const double grazing = static_cast<double>(schlick_weight(dot(wo, h)));
        f0 += kept * (1 - grazing);
        f90 += kept * grazing;
    }
    return {static_cast<Real>(f0 / kSamples), static_cast<Real>(f90 / kSamples)};
}

Real integrate_sheen(Real alpha, Real cosine) {
    const Vec3 wo = direction_of(cosine);
    double sum = 0;
    for (int i = 0; i < kSamples; ++i) {
        const Vec3 wi = sample_uniform_hemisphere(square_point(i));
        if (wi.z > 0) sum += static_cast<double>(sheen_reflection(alpha, wo, wi) * 2 * kPi);
    }
    return static_cast<Real>(sum / kSamples);
}

Real integrate_glass(Real alpha, Real cosine, Real eta) {
    const GgxAlpha a{alpha, alpha};
    const Vec3 wo = direction_of(cosine);
    double sum = 0;
    for (int i = 0; i < kGlassSamples; ++i) {
        const Vec3 h = sample_ggx_normal(a, wo, square_point(i));
        const Real reflectance = fresnel_dielectric(std::min(dot(wo, h), Real(1)), eta);
        const Real seen = ggx_masking(a, wo);
        const Vec3 mirrored = reflect(wo, h);
        Vec3 wi;
        if (mirrored.z > 0)
            sum += static_cast<double>(reflectance * ggx_masking(a, wo, mirrored, true) / seen);
        if (refract(wo, h, eta, wi) && wi.z < 0)
            sum += static_cast<double>((1 - reflectance) * ggx_masking(a, wo, wi, false) / seen);
    }
    return static_cast<Real>(sum / kGlassSamples);
}

// 2 x the integral of E(mu) mu over [0, 1], E linear between its nodes.
Vec2 average_of(const Vec2* row) {
    glm::dvec2 sum(0);
    for (int i = 0; i + 1 < kAlbedoCosines; ++i) {
        const double a = static_cast<double>(node_value(i, kAlbedoCosines));
        const double b = static_cast<double>(node_value(i + 1, kAlbedoCosines));
        const glm::dvec2 low = row[i], high = row[i + 1];
        sum += (b - a) * (low * (2 * a + b) + high * (a + 2 * b)) / 3.0;
    }
    return Vec2(sum);
}

AlbedoArrays make_arrays() {
    AlbedoArrays t;
    t.ggx.resize(size_t{kAlbedoRoughness} * kAlbedoCosines);
    t.sheen.resize(t.ggx.size());
    t.ggx_average.resize(kAlbedoRoughness);
    shared_pool().for_each(kAlbedoRoughness, [&](int64_t row) {
        const auto r = static_cast<int>(row);
        Vec2* const ggx = t.ggx.data() + r * kAlbedoCosines;
        Real* const sheen = t.sheen.data() + r * kAlbedoCosines;
        for (int c = 0; c < kAlbedoCosines; ++c) {
            const Real cosine = node_value(c, kAlbedoCosines);
            ggx[c] = integrate_ggx(node_alpha(r, kAlbedoRoughness), cosine);
            sheen[c] = integrate_sheen(
                std::max(sqr(node_value(r, kAlbedoRoughness)), kLeastSheenAlpha), cosine);
        }
        t.ggx_average[static_cast<size_t>(r)] = average_of(ggx);
    });
    constexpr int kPlane = kGlassNodes * kGlassNodes;
    t.glass.resize(size_t{2} * kGlassNodes * kPlane);
    shared_pool().for_each(2 * kGlassNodes, [&](int64_t layer) {
        const auto l = static_cast<int>(layer);
        // Reflectance 1 is no glass; the last node stands a little below.
        const Real root = sqr(std::min(node_value(l % kGlassNodes, kGlassNodes), Real(0.98)));
        const Real eta = std::max((1 + root) / (1 - root), Real(1.001));
        for (int i = 0; i < kPlane; ++i)
            t.glass[static_cast<size_t>(l * kPlane + i)] = integrate_glass(
                node_alpha(i / kGlassNodes, kGlassNodes), node_value(i % kGlassNodes, kGlassNodes),
                l < kGlassNodes ? eta : 1 / eta);
    });
    return t;
}

}  // namespace

const AlbedoArrays& albedo_arrays() {
    static const AlbedoArrays arrays = make_arrays();
    return arrays;
}

}  // namespace tp
