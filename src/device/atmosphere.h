// Light in a round atmosphere of air, aerosols and ozone; sky_image.h names the source. Lengths are
// in kilometres, angles in radians.
#pragma once

#include <teapath/core/math.h>

#include <vector>

namespace tp {

class Atmosphere {
public:
    /// `haze` multiplies the aerosols of clear air; `ground` is the albedo of the earth.
    Atmosphere(double haze, Double3 ground);

    /// Radiance towards an eye on the ground, from that elevation and that azimuth off the sun's.
    Double3 radiance(double elevation, double azimuth, double sun_elevation) const;

    /// Irradiance of what faces the sun, on the ground.
    Double3 sun_irradiance(double sun_elevation) const;

private:
    struct Point;
    struct Media;
    Media media_at(double radius) const;
    Double3 transmittance(double radius, double cosine) const;
    Double3 scattered(double radius, double sun_cosine) const;
    void fill_transmittance();
    void fill_scattered(Double3 ground);
    Double3 many_scatterings(double radius, double sun_cosine, Double3 ground) const;

    double haze_;
    std::vector<Double3> transmittance_;  // by distance to the top, by radius
    std::vector<Double3> scattered_;      // by the sun's cosine, by radius
};

}  // namespace tp
