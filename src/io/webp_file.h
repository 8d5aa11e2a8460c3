// WebP images.
#pragma once

#include <teapath/scene/image.h>

#include <string>
#include <string_view>

namespace tp {

bool is_webp(std::string_view bytes);

/// RGB, or RGBA if it has alpha, in 8 bits. Throws Error(Input); `name` stands for the file.
Image read_webp(std::string_view bytes, const std::string& name);

}  // namespace tp
