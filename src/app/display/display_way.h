// The ways of a picture from the renderer to the texture that the window draws.
#pragma once

#include <teapath/core/enum_table.h>

#include <cstdint>

namespace tp {

enum class DisplayWay : uint8_t {
    Auto,       // Image where CUDA and GL share a device, else Upload
    Image,      // the display kernel writes to the registered texture as a surface
    ArrayCopy,  // it writes to linear memory, which is copied into the mapped array
    Buffer,     // it writes to a mapped GL buffer, from which the texture is filled on the card
    Upload      // through page-locked host memory
};

template <>
struct EnumTable<DisplayWay> {
    using E = DisplayWay;
    static constexpr std::array rows = {EnumRow<E>{E::Auto, "auto", "Automatic"},
                                        EnumRow<E>{E::Image, "image", "Image: surface write"},
                                        EnumRow<E>{E::ArrayCopy, "array_copy", "Image: array copy"},
                                        EnumRow<E>{E::Buffer, "buffer", "Buffer"},
                                        EnumRow<E>{E::Upload, "upload", "Through the host"}};
};

}  // namespace tp
