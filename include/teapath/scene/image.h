// Pixels in memory, as a file held them. Shared and immutable once loaded.
#pragma once

#include <cstdint>
#include <vector>

namespace tp {

enum class PixelFormat : uint8_t { U8, U16, F32 };

/// Row-major, top row first, channels interleaved (1 grey, 2 grey and alpha, 3 RGB, 4 RGBA).
struct Image {
    int width = 0;
    int height = 0;
    int channels = 0;
    PixelFormat format = PixelFormat::U8;
    std::vector<std::byte> bytes;  // width * height * channels values of the format
    friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace tp
