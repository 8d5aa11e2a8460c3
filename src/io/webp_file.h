// WebP images.
#pragma once

#include <teapath/scene/image.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace tp {

bool is_webp(std::string_view bytes);

/// Bytes that its pixels will take, 0 if its header is damaged.
uint64_t bytes_of_webp(std::string_view bytes);

/// RGB, or RGBA if it has alpha, in 8 bits. Throws Error(Input); `name` stands for the file.
Image read_webp(std::string_view bytes, const std::string& name);

}  // namespace tp
