// The table of lights: which hittables emit, and how likely each is picked.
#pragma once

#include <teapath/device/scene_arrays.h>

namespace tp {

/// Fills arrays.lights from the hittables whose material emits, of a mesh each triangle, in an
/// alias table by power (area times luminance; a tenth of the choice is spread evenly, so that no
/// light is forgotten), and sets their Hittable::light; the others get kNoLight.
void build_lights(SceneArrays& arrays);

}  // namespace tp
