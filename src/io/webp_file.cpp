#include "webp_file.h"

#include "image_checks.h"

#include <teapath/core/error.h>

#include <webp/decode.h>

namespace tp {

bool is_webp(std::string_view bytes) {
    return bytes.size() >= 12 && bytes.starts_with("RIFF") && bytes.substr(8, 4) == "WEBP";
}

uint64_t bytes_of_webp(std::string_view bytes) {
    WebPBitstreamFeatures features;
    const auto* data = reinterpret_cast<const uint8_t*>(bytes.data());
    if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK) return 0;
    return static_cast<uint64_t>(features.width) * static_cast<uint64_t>(features.height) * 4;
}

Image read_webp(std::string_view bytes, const std::string& name) {
    const auto* data = reinterpret_cast<const uint8_t*>(bytes.data());
    const auto fail = [&](const char* what, const char* remedy) {
        throw Error(ErrorKind::Input, what, name, remedy);
    };
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK)
        fail("the WebP image is damaged or cut short", "export it again");
    if (features.has_animation) fail("the WebP image moves", "take one of its pictures");
    check_pixels(features.width, features.height, name);

    Image image;
    image.width = features.width;
    image.height = features.height;
    image.channels = features.has_alpha ? 4 : 3;
    const int stride = image.width * image.channels;
    image.bytes.resize(static_cast<size_t>(stride) * static_cast<size_t>(image.height));
    auto* out = reinterpret_cast<uint8_t*>(image.bytes.data());
    const auto decode = features.has_alpha ? WebPDecodeRGBAInto : WebPDecodeRGBInto;
    if (!decode(data, bytes.size(), out, image.bytes.size(), stride))
        fail("the WebP image is damaged or cut short", "export it again");
    return image;
}

}  // namespace tp
