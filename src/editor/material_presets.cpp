// Reflectances of metals at normal incidence and indices of refraction are the usual measured ones
// (Rec. 709, linear); albedos are those of common surfaces.
#include <teapath/core/color.h>
#include <teapath/editor/material_presets.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

MaterialPreset metal(const char* name, const Double3& color, double fuzz) {
    Material m;
    m.name = name;
    m.kind = MaterialKind::Metal;
    m.color.color = color;
    m.fuzz = fuzz;
    return {"Metals", m};
}

MaterialPreset clear(const char* name, double ior, const Double3& tint = {1, 1, 1}) {
    Material m;
    m.name = name;
    m.kind = MaterialKind::Dielectric;
    m.color.color = tint;
    m.ior = ior;
    return {"Clear", m};
}

MaterialPreset matt(const char* name, const Double3& color) {
    Material m;
    m.name = name;
    m.color.color = color;
    return {"Matt", m};
}

MaterialPreset light(const char* name, double kelvin, double strength) {
    Material m;
    m.name = name;
    m.kind = MaterialKind::DiffuseLight;
    m.color.color = {1, 1, 1};
    m.emission.color = black_body_color(kelvin);
    m.strength = strength;
    return {"Lights", m};
}

SkyPreset gradient(const char* name, const Double3& top, const Double3& bottom, double strength) {
    Background b;
    b.top = top;
    b.bottom = bottom;
    b.strength = strength;
    return {name, b};
}

SkyPreset sun(const char* name, double elevation, double haze) {
    Background b;
    b.kind = BackgroundKind::Sky;
    b.sky.sun_elevation = elevation;
    b.sky.haze = haze;
    return {name, b};
}

SkyPreset constant(const char* name, const Double3& color) {
    Background b;
    b.kind = BackgroundKind::Constant;
    b.color = color;
    return {name, b};
}

}  // namespace

const std::vector<MaterialPreset>& material_presets() {
    static const std::vector<MaterialPreset> presets = {
        metal("gold", {1.0, 0.766, 0.336}, 0.02),
        metal("copper", {0.955, 0.638, 0.538}, 0.05),
        metal("silver", {0.972, 0.960, 0.915}, 0.01),
        metal("aluminium", {0.913, 0.921, 0.925}, 0.1),
        metal("brushed iron", {0.56, 0.57, 0.58}, 0.25),
        metal("chromium", {0.55, 0.556, 0.554}, 0),
        metal("mirror", {0.98, 0.98, 0.98}, 0),
        clear("glass", 1.52),
        clear("green glass", 1.52, {0.72, 0.95, 0.80}),
        clear("water", 1.333),
        clear("ice", 1.31),
        clear("diamond", 2.417),
        clear("amber", 1.55, {1.0, 0.62, 0.18}),
        matt("chalk", {0.86, 0.86, 0.84}),
        matt("clay", {0.48, 0.24, 0.14}),
        matt("concrete", {0.40, 0.39, 0.37}),
        matt("rubber", {0.024, 0.024, 0.026}),
        matt("brick", {0.262, 0.095, 0.061}),
        matt("leaf", {0.10, 0.25, 0.045}),
        matt("snow", {0.90, 0.92, 0.95}),
        light("candle, 1,850 K", 1850, 4),
        light("light bulb, 2,700 K", 2700, 10),
        light("halogen lamp, 3,200 K", 3200, 15),
        light("daylight, 6,500 K", 6500, 10),
        light("blue sky, 12,000 K", 12000, 2)};
    return presets;
}

const std::vector<SkyPreset>& sky_presets() {
    static const std::vector<SkyPreset> presets = {
        sun("Clear sky, noon", 60, 1),
        sun("Clear sky, afternoon", 28, 1.5),
        sun("Clear sky, evening", 4, 2),
        gradient("Day", {0.5, 0.7, 1.0}, {1, 1, 1}, 1),
        gradient("Sunset", {0.16, 0.21, 0.42}, {1.0, 0.45, 0.18}, 1),
        gradient("Dusk", {0.02, 0.03, 0.09}, {0.22, 0.14, 0.16}, 1),
        gradient("Overcast", {0.85, 0.87, 0.9}, {0.6, 0.6, 0.6}, 0.9),
        gradient("Studio", {0.9, 0.9, 0.9}, {0.12, 0.12, 0.12}, 1),
        constant("White", {1, 1, 1}),
        constant("Grey", {0.18, 0.18, 0.18}),
        constant("Black", {0, 0, 0})};
    return presets;
}

Material with_preset(const Material& m, const MaterialPreset& preset) {
    Material changed = preset.material;
    changed.id = m.id;
    changed.name = m.name;
    return changed;
}

Double3 black_body_color(double kelvin) {
    const double t = std::clamp(kelvin, 1667.0, 25000.0), i = 1000 / t;
    // CIE xy of the Planckian locus as cubic splines.
    const double x = t <= 4000 ? ((-0.2661239 * i - 0.2343589) * i + 0.8776956) * i + 0.179910
                               : ((-3.0258469 * i + 2.1070379) * i + 0.2226347) * i + 0.240390;
    const double y = t <= 2222   ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
                     : t <= 4000 ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                                 : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
    const double big_x = x / y, big_z = (1 - x - y) / y;
    Double3 rgb{3.2404542 * big_x - 1.5371385 - 0.4985314 * big_z,
                -0.9692660 * big_x + 1.8760108 + 0.0415560 * big_z,
                0.0556434 * big_x - 0.2040259 + 1.0572252 * big_z};
    rgb = glm::max(rgb, Double3(0));
    return rgb / (0.2126390 * rgb.x + 0.7151687 * rgb.y + 0.0721923 * rgb.z);
}

std::optional<double> temperature_of(const Double3& color) {
    const double sum = color.x + color.y + color.z;
    if (!(sum > 0) || !std::isfinite(sum)) return std::nullopt;
    const Double3 wanted = color / sum;
    const auto share = [](double kelvin) {
        const Double3 c = black_body_color(kelvin);
        return c / (c.x + c.y + c.z);
    };
    // Red falls with the temperature.
    double low = 1667, high = 25000;
    for (int step = 0; step < 40; ++step) {
        const double middle = (low + high) / 2;
        (share(middle).x > wanted.x ? low : high) = middle;
    }
    const double kelvin = (low + high) / 2;
    if (glm::distance(share(kelvin), wanted) > 2e-3) return std::nullopt;
    return kelvin;
}

}  // namespace tp
