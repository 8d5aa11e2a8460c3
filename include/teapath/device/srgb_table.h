// The table behind SceneView::srgb_table.
#pragma once

#include <array>

namespace tp {

/// Linear values of the 8-bit sRGB codes.
const std::array<float, 256>& srgb_table();

}  // namespace tp
