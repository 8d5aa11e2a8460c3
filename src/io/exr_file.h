// OpenEXR files in memory.
#pragma once

#include <teapath/io/image_file.h>

#include <string>
#include <string_view>

namespace tp {

/// True if the bytes begin as an OpenEXR file does.
bool is_exr(std::string_view bytes);

/// Bytes that its pixels will take at most, 0 if its header is damaged.
uint64_t bytes_of_exr(std::string_view bytes);

/// R, G, B and maybe A, or Y alone, as floats; the data window is the picture. Throws
/// std::exception for what it cannot read.
Image read_exr(std::string_view bytes);

/// A scanline file of 32-bit floats (ids as 32-bit integers), ZIP compressed: the layer "" as R, G,
/// B, A, others as NAME.CHANNEL; metadata as string attributes.
std::string write_exr(const Picture& picture);

}  // namespace tp
