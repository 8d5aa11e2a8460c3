// Materials of the world to start from, and skies.
#pragma once

#include <teapath/scene/scene.h>

#include <optional>
#include <string>
#include <vector>

namespace tp {

struct MaterialPreset {
    const char* group;  // "Metals"
    Material material;  // with the preset's name
};
const std::vector<MaterialPreset>& material_presets();

struct SkyPreset {
    const char* name;
    Background background;  // without an image
};
const std::vector<SkyPreset>& sky_presets();

/// The material `m` with what the preset says; its id and name stay.
Material with_preset(const Material& m, const MaterialPreset& preset);

/// Linear Rec. 709 colour of a black body, luminance 1, channels not below 0. 1,667 to 25,000 K;
/// beyond it is clamped. Kim et al. 2002, "Design of advanced color temperature control system".
Double3 black_body_color(double kelvin);

/// The temperature whose colour has the same hue as `color`; nothing if no black body has it.
std::optional<double> temperature_of(const Double3& color);

}  // namespace tp
