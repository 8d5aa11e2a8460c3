#include <teapath/scene/scene.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double kPiDouble = 3.14159265358979323846;

}  // namespace

SunPosition sun_position(const Sky& sky) {
    if (sky.sun_by == SunRule::Angles) return {sky.sun_elevation, sky.sun_azimuth};
    const double year = 2 * kPiDouble * (sky.day - 1 + (sky.hour - 12) / 24) / 365;
    const auto cosine = [&](int n) { return std::cos(n * year); };
    const auto sine = [&](int n) { return std::sin(n * year); };
    const double declination = 0.006918 - 0.399912 * cosine(1) + 0.070257 * sine(1) -
                               0.006758 * cosine(2) + 0.000907 * sine(2) - 0.002697 * cosine(3) +
                               0.00148 * sine(3);
    const double ahead_of_mean_sun = 0.000075 + 0.001868 * cosine(1) - 0.032077 * sine(1) -
                                     0.014615 * cosine(2) - 0.040849 * sine(2);
    const double hour_angle =
        (sky.hour - 12) * kPiDouble / 12 + sky.longitude * kPiDouble / 180 + ahead_of_mean_sun;
    const double latitude = sky.latitude * kPiDouble / 180;
    const double height = std::sin(latitude) * std::sin(declination) +
                          std::cos(latitude) * std::cos(declination) * std::cos(hour_angle);
    const double east = -std::cos(declination) * std::sin(hour_angle);
    const double north = std::cos(latitude) * std::sin(declination) -
                         std::sin(latitude) * std::cos(declination) * std::cos(hour_angle);
    return {std::asin(std::clamp(height, -1.0, 1.0)) * 180 / kPiDouble,
            std::atan2(east, north) * 180 / kPiDouble};
}

}  // namespace tp
