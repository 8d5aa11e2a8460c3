// Which random number of a sample decides what. The camera has eight dimensions, then every
// surface that the path meets has eight.
#pragma once

#include <teapath/core/host_device.h>

#include <cstdint>

namespace tp {

inline constexpr uint32_t kDimensionPixel = 0;  // two: place within the pixel
inline constexpr uint32_t kDimensionLens = 2;   // two: place on the lens
inline constexpr uint32_t kDimensionTime = 4;
inline constexpr uint32_t kDimensionChannel = 5;  // which of red, green, blue dispersion keeps

inline constexpr uint32_t kDimensionBsdf = 0;         // two: direction
inline constexpr uint32_t kDimensionLight = 2;        // two: point on the light
inline constexpr uint32_t kDimensionLightChoice = 4;  // which light
inline constexpr uint32_t kDimensionRoulette = 5;
inline constexpr uint32_t kDimensionLobe = 6;  // third number of the bsdf
inline constexpr uint32_t kDimensionOpacity = 7;

/// The first dimension of the path's surface number `vertex` = 1, 2, …
TP_HD uint32_t vertex_dimension(uint32_t vertex) {
    return 8 * vertex;
}

}  // namespace tp
