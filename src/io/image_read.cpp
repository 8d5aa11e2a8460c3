#include "exr_file.h"
#include "image_checks.h"
#include "webp_file.h"
#include "whole_file.h"

#include <teapath/core/error.h>
#include <teapath/io/image_file.h>

#include <fmt/format.h>
#include <stb/stb_image.h>

#include <climits>
#include <cstring>
#include <exception>
#include <memory>

namespace tp {
namespace {

constexpr uintmax_t kMaxFileBytes = INT_MAX;

struct StbFree {
    void operator()(void* pixels) const { stbi_image_free(pixels); }
};

[[noreturn]] void fail_as_damaged(const std::string& file) {
    throw Error(ErrorKind::Input, "the image is damaged or cut short", file, "export it again");
}

// Pixels that stb decoded, in the bit depth of the file.
Image read_stb(std::string_view bytes, const std::string& file) {
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    // Before anything else: the question for the size reads tables too.
    if (!has_sound_huffman_tables(bytes)) fail_as_damaged(file);
    int width = 0, height = 0, channels = 0;
    if (!stbi_info_from_memory(data, size, &width, &height, &channels) || width < 1 || height < 1)
        throw Error(ErrorKind::Input, "this is not an image that can be read", file,
                    "known: JPEG, PNG, WebP, TGA, BMP, PSD, GIF, HDR, PIC, PNM, EXR");
    check_pixels(width, height, file);

    const bool is_hdr = stbi_is_hdr_from_memory(data, size) != 0;
    if (is_hdr && !has_whole_runs(bytes, width, height)) fail_as_damaged(file);

    Image image;
    std::unique_ptr<void, StbFree> pixels;
    const int wanted = is_pic(bytes) ? 4 : 0;  // 0: as many channels as there are
    if (is_hdr) {
        image.format = PixelFormat::F32;
        pixels.reset(stbi_loadf_from_memory(data, size, &width, &height, &channels, wanted));
    } else if (stbi_is_16_bit_from_memory(data, size) || is_psd_of_16_bits(bytes)) {
        image.format = PixelFormat::U16;
        pixels.reset(stbi_load_16_from_memory(data, size, &width, &height, &channels, wanted));
    } else {
        image.format = PixelFormat::U8;
        pixels.reset(stbi_load_from_memory(data, size, &width, &height, &channels, wanted));
    }
    if (wanted) channels = wanted;
    if (!pixels)
        throw Error(ErrorKind::Input,
                    fmt::format("the image is damaged ({})", stbi_failure_reason()), file,
                    "export it again");
    image.width = width;
    image.height = height;
    image.channels = channels;
    const size_t depth = image.format == PixelFormat::U8    ? 1
                         : image.format == PixelFormat::U16 ? 2
                                                            : 4;
    image.bytes.resize(static_cast<size_t>(width) * static_cast<size_t>(height) *
                       static_cast<size_t>(channels) * depth);
    std::memcpy(image.bytes.data(), pixels.get(), image.bytes.size());
    return image;
}

}  // namespace

Image read_image_from_memory(std::string_view bytes, const std::string& name) {
    if (bytes.size() > kMaxFileBytes)
        throw Error(ErrorKind::Input, "the image is larger than 2 GiB", name, "make it smaller");
    if (is_webp(bytes)) return read_webp(bytes, name);
    if (!is_exr(bytes)) return read_stb(bytes, name);
    try {
        return read_exr(bytes);
    } catch (const std::exception& error) {
        throw Error(ErrorKind::Input,
                    fmt::format("the OpenEXR file cannot be read: {}", error.what()), name,
                    "export it again");
    }
}

uint64_t bytes_of_image(std::string_view bytes) {
    if (bytes.size() > kMaxFileBytes || !has_sound_huffman_tables(bytes)) return 0;
    if (is_webp(bytes)) return bytes_of_webp(bytes);
    if (is_exr(bytes)) return bytes_of_exr(bytes);
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    if (!stbi_info_from_memory(data, size, &width, &height, &channels) || width < 1 || height < 1)
        return 0;
    const uint64_t depth = stbi_is_hdr_from_memory(data, size)                                  ? 4
                           : stbi_is_16_bit_from_memory(data, size) || is_psd_of_16_bits(bytes) ? 2
                                                                                                : 1;
    return static_cast<uint64_t>(width) * static_cast<uint64_t>(height) *
           static_cast<uint64_t>(channels) * depth;
}

Image read_image(const std::filesystem::path& file) {
    return read_image_from_memory(read_whole_file(file, "an image", kMaxFileBytes), file.string());
}

}  // namespace tp
