#include "exr_file.h"
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
constexpr int64_t kMaxPixels = int64_t{1} << 28;

struct StbFree {
    void operator()(void* pixels) const { stbi_image_free(pixels); }
};

// Walks the run-length coding of a Radiance file, for stb's decoder would turn for ever on a run of
// no pixels, which is also what it reads behind the end of a file cut short.
bool has_whole_runs(std::string_view bytes, int width, int height) {
    if (width < 8 || width >= 32768) return true;  // never coded in runs
    const size_t header_end = bytes.find("\n\n");
    const size_t line_end =
        header_end == bytes.npos ? bytes.npos : bytes.find('\n', header_end + 2);
    if (line_end == bytes.npos || bytes.find('\0') < line_end) return false;
    size_t at = line_end + 1;
    const auto byte = [&](size_t i) { return static_cast<uint8_t>(bytes[i]); };
    for (int row = 0; row < height; ++row) {
        if (at + 4 > bytes.size()) return false;
        const bool coded = byte(at) == 2 && byte(at + 1) == 2 && byte(at + 2) < 128;
        if (!coded) return row == 0;  // plain pixels from the first row on
        at += 4;
        for (int channel = 0; channel < 4; ++channel) {
            for (int x = 0; x < width;) {
                if (at + 2 > bytes.size()) return false;
                const int code = byte(at), count = code > 128 ? code - 128 : code;
                if (count == 0 || count > width - x) return false;
                at += code > 128 ? 2 : static_cast<size_t>(count) + 1;
                x += count;
            }
        }
    }
    return at <= bytes.size();
}

// Pixels that stb decoded, in the bit depth of the file.
Image read_stb(const std::string& bytes, const std::string& file) {
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    if (!stbi_info_from_memory(data, size, &width, &height, &channels) || width < 1 || height < 1)
        throw Error(ErrorKind::Input, "this is not an image that can be read", file,
                    "known: JPEG, PNG, TGA, BMP, PSD, GIF, HDR, PIC, PNM, EXR");
    if (int64_t{width} * height > kMaxPixels)
        throw Error(ErrorKind::Input,
                    fmt::format("the image has {} x {} pixels, which is too many", width, height),
                    file, "at most 268,435,456");

    Image image;
    std::unique_ptr<void, StbFree> pixels;
    if (stbi_is_hdr_from_memory(data, size)) {
        if (!has_whole_runs(bytes, width, height))
            throw Error(ErrorKind::Input, "the image is damaged or cut short", file,
                        "export it again");
        image.format = PixelFormat::F32;
        pixels.reset(stbi_loadf_from_memory(data, size, &width, &height, &channels, 0));
    } else if (stbi_is_16_bit_from_memory(data, size)) {
        image.format = PixelFormat::U16;
        pixels.reset(stbi_load_16_from_memory(data, size, &width, &height, &channels, 0));
    } else {
        image.format = PixelFormat::U8;
        pixels.reset(stbi_load_from_memory(data, size, &width, &height, &channels, 0));
    }
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

Image read_image(const std::filesystem::path& file) {
    const std::string bytes = read_whole_file(file, "an image", kMaxFileBytes);
    if (!is_exr(bytes)) return read_stb(bytes, file.string());
    try {
        return read_exr(bytes);
    } catch (const std::exception& error) {
        throw Error(ErrorKind::Input,
                    fmt::format("the OpenEXR file cannot be read: {}", error.what()), file.string(),
                    "export it again");
    }
}

}  // namespace tp
