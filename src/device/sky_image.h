// The light of a clear sky as an image: scattering by air, aerosols and ozone in a round atmosphere
// (Hillaire, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique", 2020, with
// its constants; many scatterings as its equation 10).
#pragma once

#include <teapath/core/math.h>
#include <teapath/scene/image.h>

#include <memory>

namespace tp {

struct SkyParameters {
    double sun_elevation = 35;      // degrees
    double haze = 1;                // aerosols, times those of clear air
    Double3 ground{0.3, 0.3, 0.3};  // albedo

    friend bool operator==(const SkyParameters&, const SkyParameters&) = default;
};

/// The unit of radiance is such that a white sheet in the sun at noon has about 1.
struct SkyImage {
    std::shared_ptr<const Image> image;  // equirectangular, float RGB; the sun's azimuth is that
                                         // of -z, its disk is not in it
    Double3 sun_irradiance{0, 0, 0};     // of what faces the sun, at the ground
    double irradiance = 0;               // luminance that the sky gives to level ground
};

/// Made on all cores, once for the same parameters as long as somebody holds it.
std::shared_ptr<const SkyImage> sky_image(const SkyParameters& parameters);

}  // namespace tp
