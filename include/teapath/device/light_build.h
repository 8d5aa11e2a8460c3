// The table of lights: which hittables emit, and how likely each is picked.
#pragma once

#include <teapath/kernel/records.h>

#include <vector>

namespace tp {

/// Lists the hittables whose material emits, in an alias table by power (area times luminance; a
/// tenth of the choice is spread evenly, so that no light is forgotten), and sets their
/// Hittable::light; the others get kNoLight.
std::vector<LightRecord> build_lights(std::vector<Hittable>& hittables,
                                      const std::vector<MaterialRecord>& materials);

}  // namespace tp
