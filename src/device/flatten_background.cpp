#include "flatten_background.h"

#include "sky_image.h"

#include <teapath/core/color.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

void set_rotation(double degrees, BackgroundRecord& record) {
    record.cos_rotation = static_cast<Real>(std::cos(degrees * kRadiansPerDegree));
    record.sin_rotation = static_cast<Real>(std::sin(degrees * kRadiansPerDegree));
}

// The disk of the sun, and how often it is aimed at beside the sky.
void add_sun(const Background& b, const SunPosition& sun, const SkyImage& sky,
             BackgroundRecord& record) {
    const double elevation = sun.elevation * kRadiansPerDegree;
    const double azimuth = sun.azimuth * kRadiansPerDegree;
    record.sun_direction =
        normalize(Vec3(Double3(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                               -std::cos(azimuth) * std::cos(elevation))));
    const double radius = b.sky.sun_size / 2 * kRadiansPerDegree;
    const Double3 irradiance = sky.sun_irradiance * b.sky.sun_strength;
    const double direct = luminance(Vec3(irradiance));
    if (!(direct > 0)) return;
    const double chord = 2 * std::sin(radius / 2);
    record.sun_chord2 = static_cast<Real>(chord * chord);
    // A disk of that radius seen head-on gives the irradiance L pi sin^2 r.
    const double solid = 3.14159265358979323846 * std::pow(std::sin(radius), 2);
    record.sun_radiance = Vec3(irradiance / solid) * record.scale;
    record.sun_probability =
        static_cast<Real>(std::clamp(direct / (direct + sky.irradiance), 0.1, 0.8));
}

void add_sky(const Background& b, TexturePacker& textures, SceneArrays& arrays) {
    const SunPosition sun = sun_position(b.sky);
    const std::shared_ptr<const SkyImage> sky =
        sky_image({sun.elevation, b.sky.haze, b.sky.ground});
    BackgroundRecord& record = arrays.background;
    record.texture = textures.add_image(sky->image, ColorSpace::Linear);
    arrays.environment = environment_of(sky->image, false);
    set_rotation(-sun.azimuth, record);
    add_sun(b, sun, *sky, record);
}

}  // namespace

void flatten_background(const Background& b, TexturePacker& textures, SceneArrays& arrays) {
    BackgroundRecord& record = arrays.background;
    record = {};
    record.kind = b.kind;
    record.scale = Vec3(Double3(b.strength));
    set_rotation(b.rotation, record);
    arrays.environment = nullptr;
    switch (b.kind) {
        case BackgroundKind::Constant: record.bottom = Vec3(b.color); break;
        case BackgroundKind::Gradient:
            record.bottom = Vec3(b.bottom);
            record.top = Vec3(b.top);
            break;
        case BackgroundKind::Image:
            record.scale *= Vec3(b.tint);
            record.texture = textures.add_image(b.file.image, b.color_space);
            if (b.file.image)
                arrays.environment =
                    environment_of(b.file.image, is_srgb(*b.file.image, b.color_space));
            break;
        case BackgroundKind::Sky:
            record.scale *= Vec3(b.tint);
            add_sky(b, textures, arrays);
            break;
    }
    record.backdrop = b.backdrop;
    record.backdrop_color = Vec3(b.backdrop_color);
    if (b.backdrop == BackdropKind::Image)
        record.backdrop_texture = textures.add_image(b.backdrop_file.image, b.color_space);
}

}  // namespace tp
