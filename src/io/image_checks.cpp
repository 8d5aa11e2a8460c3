#include "image_checks.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

namespace tp {
namespace {

// The byte at `i`, 0 behind the end as stb reads it.
uint8_t byte_at(std::string_view bytes, size_t i) {
    return i < bytes.size() ? static_cast<uint8_t>(bytes[i]) : uint8_t{0};
}

int big_endian_16(std::string_view bytes, size_t i) {
    return byte_at(bytes, i) << 8 | byte_at(bytes, i + 1);
}

// The tables of a DHT segment whose length stands at `at`; moves `at` behind what stb reads of it.
bool are_sound_tables(std::string_view bytes, size_t& at) {
    int left = big_endian_16(bytes, at) - 2;
    at += 2;
    while (left > 0 && at < bytes.size()) {
        int codes = 0;
        for (size_t length = 1; length <= 16; ++length)
            codes += byte_at(bytes, at + length);
        if (codes > 256) return false;
        at += static_cast<size_t>(17 + codes);
        left -= 17 + codes;
    }
    return true;
}

}  // namespace

void check_pixels(int width, int height, const std::string& name) {
    constexpr int64_t kMaxPixels = int64_t{1} << 28;
    if (int64_t{width} * height > kMaxPixels)
        throw Error(ErrorKind::Input,
                    fmt::format("the image has {} x {} pixels, which is too many", width, height),
                    name, "at most 268,435,456");
}

bool has_whole_runs(std::string_view hdr, int width, int height) {
    if (width < 8 || width >= 32768) return true;  // never coded in runs
    const size_t header_end = hdr.find("\n\n");
    const size_t line_end = header_end == hdr.npos ? hdr.npos : hdr.find('\n', header_end + 2);
    if (line_end == hdr.npos || hdr.find('\0') < line_end) return false;
    size_t at = line_end + 1;
    for (int row = 0; row < height; ++row) {
        if (at + 4 > hdr.size()) return false;
        const bool coded =
            byte_at(hdr, at) == 2 && byte_at(hdr, at + 1) == 2 && byte_at(hdr, at + 2) < 128;
        if (!coded) return row == 0;  // plain pixels from the first row on
        at += 4;
        for (int channel = 0; channel < 4; ++channel) {
            for (int x = 0; x < width;) {
                if (at + 2 > hdr.size()) return false;
                const int code = byte_at(hdr, at), count = code > 128 ? code - 128 : code;
                if (count == 0 || count > width - x) return false;
                at += code > 128 ? 2 : static_cast<size_t>(count) + 1;
                x += count;
            }
        }
    }
    return at <= hdr.size();
}

bool has_sound_huffman_tables(std::string_view bytes) {
    // The first marker too may have padding before it.
    const size_t start = bytes.find_first_not_of('\xff');
    if (start == 0 || start == bytes.npos || byte_at(bytes, start) != 0xd8) return true;
    for (size_t at = start + 1;;) {
        // The next marker, over padding and over a scan's data.
        while (at < bytes.size() && byte_at(bytes, at) != 0xff)
            ++at;
        while (at < bytes.size() && byte_at(bytes, at) == 0xff)
            ++at;
        if (at >= bytes.size()) return true;
        const int marker = byte_at(bytes, at++);
        const bool stands_alone = marker == 0 || marker == 1 || (marker >= 0xd0 && marker <= 0xd8);
        if (stands_alone) continue;
        if (marker == 0xd9) return true;  // end of image
        if (marker == 0xc4) {
            if (!are_sound_tables(bytes, at)) return false;
        } else {
            at += static_cast<size_t>(big_endian_16(bytes, at));
        }
    }
}

bool is_pic(std::string_view bytes) {
    return bytes.starts_with("\x53\x80\xf6\x34");
}

bool is_psd_of_16_bits(std::string_view bytes) {
    return bytes.starts_with("8BPS") && big_endian_16(bytes, 22) == 16;
}

}  // namespace tp
