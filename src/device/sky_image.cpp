#include "sky_image.h"

#include "atmosphere.h"

#include <teapath/core/color.h>
#include <teapath/core/parallel.h>

#include <cmath>
#include <mutex>
#include <vector>

namespace tp {
namespace {

constexpr int kWidth = 1024, kHeight = 512;
constexpr double kPiDouble = 3.14159265358979323846;

// One row of the sky; the sun is at the edges of the image, so that both halves are alike.
void fill_row(const Atmosphere& air, double sun_elevation, int row, float* pixels) {
    const double elevation = kPiDouble * (0.5 - (row + 0.5) / kHeight);
    for (int x = 0; x < kWidth / 2; ++x) {
        const double azimuth = 2 * kPiDouble * (x + 0.5) / kWidth;
        const Double3 l = air.radiance(elevation, azimuth, sun_elevation);
        for (int c = 0; c < 3; ++c) {
            const auto value = static_cast<float>(l[c]);
            pixels[3 * x + c] = value;
            pixels[3 * (kWidth - 1 - x) + c] = value;
        }
    }
}

// What level ground gets from the rows above the horizon.
Double3 ground_irradiance(const std::vector<float>& pixels) {
    Double3 sum{0, 0, 0};
    for (int y = 0; y < kHeight / 2; ++y) {
        const double theta = kPiDouble * (y + 0.5) / kHeight;
        const double weight = std::sin(theta) * std::cos(theta);
        for (int x = 0; x < kWidth; ++x)
            for (int c = 0; c < 3; ++c)
                sum[c] += weight * static_cast<double>(
                                       pixels[static_cast<size_t>(3 * (y * kWidth + x) + c)]);
    }
    return sum * (2 * kPiDouble / kWidth) * (kPiDouble / kHeight);
}

std::shared_ptr<const SkyImage> make(const SkyParameters& p) {
    const Atmosphere air(p.haze, p.ground);
    const double sun = p.sun_elevation * kPiDouble / 180;
    std::vector<float> pixels(size_t{3} * kWidth * kHeight);
    parallel_for(kHeight / 2, 8, [&](int64_t first, int64_t last) {
        for (auto y = static_cast<int>(first); y < static_cast<int>(last); ++y)
            fill_row(air, sun, y, pixels.data() + static_cast<size_t>(3 * y * kWidth));
    });

    // The ground, by what falls on it.
    auto sky = std::make_shared<SkyImage>();
    sky->sun_irradiance = air.sun_irradiance(sun);
    const Double3 from_sky = ground_irradiance(pixels);
    sky->irradiance = static_cast<double>(luminance(Vec3(from_sky)));
    const Double3 falling = from_sky + sky->sun_irradiance * std::max(std::sin(sun), 0.0);
    const Double3 ground = falling * p.ground / kPiDouble;
    for (size_t i = pixels.size() / 2; i < pixels.size(); ++i)
        pixels[i] = static_cast<float>(ground[static_cast<int>(i % 3)]);

    Image image;
    image.width = kWidth;
    image.height = kHeight;
    image.channels = 3;
    image.format = PixelFormat::F32;
    const auto* bytes = reinterpret_cast<const std::byte*>(pixels.data());
    image.bytes.assign(bytes, bytes + pixels.size() * sizeof(float));
    sky->image = std::make_shared<const Image>(std::move(image));
    return sky;
}

}  // namespace

std::shared_ptr<const SkyImage> sky_image(const SkyParameters& parameters) {
    static std::mutex mutex;
    static SkyParameters known;
    static std::shared_ptr<const SkyImage> last;
    const std::lock_guard lock(mutex);
    if (last && known == parameters) return last;
    last = make(parameters);
    known = parameters;
    return last;
}

}  // namespace tp
