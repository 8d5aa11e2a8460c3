#include "film_resolve.h"

#include <teapath/core/color.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

// Standard error of the mean luminance from the sums of luminance and of its square.
float standard_error(double mean, double mean_square, int64_t samples) {
    if (samples < 2) return 0;
    const double variance = std::max(0.0, mean_square - mean * mean);
    return static_cast<float>(std::sqrt(variance / static_cast<double>(samples - 1)));
}

void resolve_radiance(const FilmSums& sums, int64_t samples, FilmImage& image) {
    const uint32_t pixels = sums.totals.size;
    image.radiance.resize(size_t{3} * pixels);
    image.standard_error.resize(pixels);
    for (uint32_t i = 0; i < pixels; ++i) {
        const Vec3 mean = mean_radiance(sums.totals[i], sums.open[i], samples);
        for (int c = 0; c < 3; ++c)
            image.radiance[3 * size_t{i} + static_cast<size_t>(c)] = static_cast<float>(mean[c]);
        const Total& t = sums.totals[i];
        const double square = static_cast<double>(t.sum.w) + static_cast<double>(t.compensation.w) +
                              static_cast<double>(sums.open[i].w);
        image.standard_error[i] =
            standard_error(static_cast<double>(luminance(mean)),
                           samples > 0 ? square / static_cast<double>(samples) : 0, samples);
    }
}

void resolve_features(const FilmSums& sums, int64_t samples, FilmImage& image) {
    const uint32_t pixels = sums.features.size;
    image.alpha.resize(pixels);
    image.albedo.resize(size_t{3} * pixels);
    image.normal.resize(size_t{3} * pixels);
    image.depth.resize(pixels);
    const Real scale = samples > 0 ? 1 / static_cast<Real>(samples) : 0;
    for (uint32_t i = 0; i < pixels; ++i) {
        const FeatureSum& f = sums.features[i];
        image.alpha[i] = static_cast<float>(f.hits * scale);
        for (int c = 0; c < 3; ++c) {
            image.albedo[3 * size_t{i} + static_cast<size_t>(c)] =
                static_cast<float>(f.albedo[c] * scale);
            image.normal[3 * size_t{i} + static_cast<size_t>(c)] =
                static_cast<float>(f.normal[c] * scale);
        }
        image.depth[i] = f.hits > 0 ? static_cast<float>(f.depth / f.hits) : 0;
    }
}

void resolve_ids(const FilmSums& sums, const HittableIds& ids, FilmImage& image) {
    image.object_id.assign(sums.hittables.size, 0);
    image.material_id.assign(sums.hittables.size, 0);
    for (uint32_t i = 0; i < sums.hittables.size; ++i) {
        if (sums.hittables[i] >= ids.hittables.size) continue;
        const Hittable& h = ids.hittables[sums.hittables[i]];
        image.object_id[i] = h.object;
        image.material_id[i] = ids.material_ids[h.material];
    }
}

}  // namespace

FilmImage resolve_film(const FilmSums& sums, const HittableIds& ids, int width, int height,
                       int64_t samples) {
    FilmImage image;
    image.width = width;
    image.height = height;
    image.samples = samples;
    resolve_radiance(sums, samples, image);
    if (!sums.features.empty()) resolve_features(sums, samples, image);
    if (!sums.hittables.empty()) resolve_ids(sums, ids, image);
    return image;
}

FilmImage resolve_guides(Span<const FeatureSum> features, int width, int height, int64_t samples) {
    FilmImage image;
    image.width = width;
    image.height = height;
    image.samples = samples;
    FilmSums sums;
    sums.features = features;
    resolve_features(sums, samples, image);
    return image;
}

}  // namespace tp
