// The window's icon, drawn by code: a cup of tea.
#pragma once

#include <cstdint>
#include <vector>

namespace tp {

/// RGBA bytes of a square icon, row-major, top row first, not premultiplied.
std::vector<uint8_t> window_icon(int size);

}  // namespace tp
