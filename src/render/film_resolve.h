// From the film's sums to means on the host; used by every backend after its download.
#pragma once

#include <teapath/core/span.h>
#include <teapath/kernel/film_view.h>
#include <teapath/render/film_image.h>

#include <cstdint>

namespace tp {

/// The film's planes, row-major, one entry a pixel; features empty where not asked for.
struct FilmSums {
    Span<const Total> totals;
    Span<const BlockSum> open;  // the block that is not full yet
    Span<const FeatureSum> features;
    Span<const uint32_t> hittables;  // at the pixels' centres, kNoHit = none
};

/// Which object and material a hittable is.
struct HittableIds {
    Span<const Hittable> hittables;
    Span<const uint32_t> material_ids;
};

FilmImage resolve_film(const FilmSums& sums, const HittableIds& ids, int width, int height,
                       int64_t samples);

/// The feature planes alone, of sums of that many samples.
FilmImage resolve_guides(Span<const FeatureSum> features, int width, int height, int64_t samples);

}  // namespace tp
