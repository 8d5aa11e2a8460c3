#include "atmosphere.h"

#include <teapath/core/parallel.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double kPiDouble = 3.14159265358979323846;
constexpr double kGround = 6360, kTop = 6460;  // radii
constexpr double kEye = kGround + 0.05;
constexpr double kSolarIrradiance = 4;  // beyond the atmosphere

// Per kilometre at the ground, and the heights over which air and aerosols thin out by e.
const Double3 kAir{0.005802, 0.013558, 0.0331};
const Double3 kOzone{0.00065, 0.001881, 0.000085};
constexpr double kAerosolScattering = 0.003996, kAerosolExtinction = 0.00444;
constexpr double kAirHeight = 8, kAerosolHeight = 1.2;
constexpr double kAerosolForward = 0.8;  // mean cosine

constexpr int kTransmittanceColumns = 256, kTransmittanceRows = 64;
constexpr int kScatteredColumns = 32, kScatteredRows = 32;

Double3 exp(Double3 v) {
    return {std::exp(v.x), std::exp(v.y), std::exp(v.z)};
}

double safe_root(double x) {
    return std::sqrt(std::max(x, 0.0));
}

// From a point at `radius` along a direction with that cosine from straight up.
double distance_to_sphere(double radius, double cosine, double sphere) {
    const double discriminant = radius * radius * (cosine * cosine - 1) + sphere * sphere;
    return discriminant < 0 ? -1 : -radius * cosine + std::sqrt(discriminant);
}
bool meets_ground(double radius, double cosine) {
    return cosine < 0 && radius * radius * (cosine * cosine - 1) + kGround * kGround >= 0;
}
double distance_to_ground(double radius, double cosine) {
    return -radius * cosine -
           safe_root(radius * radius * (cosine * cosine - 1) + kGround * kGround);
}

double air_phase(double cosine) {
    return 3 / (16 * kPiDouble) * (1 + cosine * cosine);
}
// Cornette and Shanks, 1992.
double aerosol_phase(double cosine) {
    const double g2 = kAerosolForward * kAerosolForward;
    return 3 / (8 * kPiDouble) * (1 - g2) * (1 + cosine * cosine) /
           ((2 + g2) * std::pow(1 + g2 - 2 * kAerosolForward * cosine, 1.5));
}

Double3 bilinear(const std::vector<Double3>& table, int columns, int rows, double x, double y) {
    const double column = std::clamp(x, 0.0, 1.0) * (columns - 1);
    const double row = std::clamp(y, 0.0, 1.0) * (rows - 1);
    const int x0 = std::min(static_cast<int>(column), columns - 2);
    const int y0 = std::min(static_cast<int>(row), rows - 2);
    const auto at = [&](int i, int j) { return table[static_cast<size_t>(j * columns + i)]; };
    const double fx = column - x0, fy = row - y0;
    return glm::mix(glm::mix(at(x0, y0), at(x0 + 1, y0), fx),
                    glm::mix(at(x0, y0 + 1), at(x0 + 1, y0 + 1), fx), fy);
}

// Longest and shortest way to the top from `radius`, by which the table is spaced.
struct WaysUp {
    double horizon = safe_root(kTop * kTop - kGround * kGround);
    double rho, least, most;

    explicit WaysUp(double radius)
        : rho(safe_root(radius * radius - kGround * kGround)),
          least(kTop - radius),
          most(rho + horizon) {}
};

}  // namespace

struct Atmosphere::Media {
    Double3 air;      // scattering
    double aerosols;  // scattering
    Double3 extinction;

    Double3 scattering() const { return air + Double3(aerosols); }
};

Atmosphere::Media Atmosphere::media_at(double radius) const {
    const double height = std::max(radius - kGround, 0.0);
    const double air = std::exp(-height / kAirHeight);
    const double aerosols = haze_ * std::exp(-height / kAerosolHeight);
    const double ozone = std::max(0.0, 1 - std::abs(height - 25) / 15);
    Media m;
    m.air = kAir * air;
    m.aerosols = kAerosolScattering * aerosols;
    m.extinction = m.air + Double3(kAerosolExtinction * aerosols) + kOzone * ozone;
    return m;
}

Atmosphere::Atmosphere(double haze, Double3 ground) : haze_(haze) {
    fill_transmittance();
    fill_scattered(ground);
}

void Atmosphere::fill_transmittance() {
    transmittance_.resize(size_t{kTransmittanceColumns} * kTransmittanceRows);
    parallel_for(kTransmittanceRows, 4, [&](int64_t first, int64_t last) {
        for (auto j = static_cast<int>(first); j < static_cast<int>(last); ++j) {
            const WaysUp from_ground(kGround);
            const double rho = from_ground.horizon * j / (kTransmittanceRows - 1);
            const double radius = std::sqrt(rho * rho + kGround * kGround);
            const WaysUp ways(radius);
            for (int i = 0; i < kTransmittanceColumns; ++i) {
                const double way =
                    ways.least + (ways.most - ways.least) * i / (kTransmittanceColumns - 1);
                const double cosine = way > 0
                                          ? std::clamp((kTop * kTop - radius * radius - way * way) /
                                                           (2 * radius * way),
                                                       -1.0, 1.0)
                                          : 1;
                constexpr int kSteps = 40;
                Double3 depth{0, 0, 0};
                for (int k = 0; k < kSteps; ++k) {
                    const double t = way * (k + 0.5) / kSteps;
                    depth += media_at(std::sqrt(radius * radius + t * t + 2 * radius * cosine * t))
                                 .extinction;
                }
                transmittance_[static_cast<size_t>(j * kTransmittanceColumns + i)] =
                    exp(-depth * (way / kSteps));
            }
        }
    });
}

// To the top; 0 where the ground is in the way.
Double3 Atmosphere::transmittance(double radius, double cosine) const {
    if (meets_ground(radius, cosine)) return {0, 0, 0};
    const WaysUp ways(radius);
    const double way = distance_to_sphere(radius, cosine, kTop);
    return bilinear(transmittance_, kTransmittanceColumns, kTransmittanceRows,
                    (way - ways.least) / (ways.most - ways.least), ways.rho / ways.horizon);
}

// What arrives at a point after two scatterings and more, from every direction alike, for a solar
// irradiance of 1.
Double3 Atmosphere::many_scatterings(double radius, double sun_cosine, Double3 ground) const {
    constexpr int kDirections = 8, kSteps = 20;
    const double sun_sine = safe_root(1 - sun_cosine * sun_cosine);
    Double3 second{0, 0, 0}, passed_on{0, 0, 0};
    for (int d = 0; d < kDirections * kDirections; ++d) {
        const double cosine = 1 - 2 * (d / kDirections + 0.5) / kDirections;
        const double phi = 2 * kPiDouble * (d % kDirections + 0.5) / kDirections;
        const double along_sun =
            safe_root(1 - cosine * cosine) * std::cos(phi) * sun_sine + cosine * sun_cosine;
        const bool hits = meets_ground(radius, cosine);
        const double way =
            hits ? distance_to_ground(radius, cosine) : distance_to_sphere(radius, cosine, kTop);
        const double step = way / kSteps;
        Double3 left{1, 1, 1};
        double r = radius, sun = sun_cosine;
        for (int k = 0; k < kSteps; ++k) {
            const double t = step * (k + 0.5);
            r = std::sqrt(radius * radius + t * t + 2 * radius * cosine * t);
            sun = (radius * sun_cosine + t * along_sun) / r;
            const Media m = media_at(r);
            const Double3 through = exp(-m.extinction * step);
            const Double3 share = left * m.scattering() * (1.0 - through) / m.extinction;
            second += share * transmittance(r, sun) / (4 * kPiDouble);
            passed_on += share;
            left *= through;
        }
        if (hits) {
            const double cosine_there = (radius * sun_cosine + way * along_sun) / kGround;
            second += left * transmittance(kGround, cosine_there) *
                      (std::max(cosine_there, 0.0) / kPiDouble) * ground;
        }
    }
    constexpr double kCount = kDirections * kDirections;
    return second / kCount / (1.0 - passed_on / kCount);
}

void Atmosphere::fill_scattered(Double3 ground) {
    scattered_.resize(size_t{kScatteredColumns} * kScatteredRows);
    parallel_for(kScatteredRows, 2, [&](int64_t first, int64_t last) {
        for (auto j = static_cast<int>(first); j < static_cast<int>(last); ++j)
            for (int i = 0; i < kScatteredColumns; ++i)
                scattered_[static_cast<size_t>(j * kScatteredColumns + i)] = many_scatterings(
                    kGround + (kTop - kGround) * (0.001 + 0.998 * j / (kScatteredRows - 1)),
                    2.0 * i / (kScatteredColumns - 1) - 1, ground);
    });
}

Double3 Atmosphere::scattered(double radius, double sun_cosine) const {
    return bilinear(scattered_, kScatteredColumns, kScatteredRows, (sun_cosine + 1) / 2,
                    (radius - kGround) / (kTop - kGround));
}

Double3 Atmosphere::radiance(double elevation, double azimuth, double sun_elevation) const {
    const double cosine = std::sin(elevation), sun_cosine = std::sin(sun_elevation);
    const double along_sun =
        std::cos(elevation) * std::cos(sun_elevation) * std::cos(azimuth) + cosine * sun_cosine;
    const double way = meets_ground(kEye, cosine) ? distance_to_ground(kEye, cosine)
                                                  : distance_to_sphere(kEye, cosine, kTop);
    const double air = air_phase(along_sun), aerosols = aerosol_phase(along_sun);
    constexpr int kSteps = 40;
    Double3 sum{0, 0, 0}, left{1, 1, 1};
    double before = 0;
    for (int k = 1; k <= kSteps; ++k) {
        // Shorter steps near the eye, where the air is dense.
        const double share = static_cast<double>(k) / kSteps;
        const double end = way * share * share;
        const double t = (before + end) / 2, step = end - before;
        before = end;
        const double r = std::sqrt(kEye * kEye + t * t + 2 * kEye * cosine * t);
        const double sun = (kEye * sun_cosine + t * along_sun) / r;
        const Media m = media_at(r);
        const Double3 source =
            (m.air * air + Double3(m.aerosols * aerosols)) * transmittance(r, sun) +
            m.scattering() * scattered(r, sun);
        const Double3 through = exp(-m.extinction * step);
        sum += left * source * (1.0 - through) / m.extinction;
        left *= through;
    }
    return sum * kSolarIrradiance;
}

Double3 Atmosphere::sun_irradiance(double sun_elevation) const {
    return transmittance(kEye, std::sin(sun_elevation)) * kSolarIrradiance;
}

}  // namespace tp
