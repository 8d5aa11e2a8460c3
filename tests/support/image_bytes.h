// A small picture as the bytes of image files, as the formats' specifications say: PNG, BMP, TGA,
// PSD, GIF, PIC.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>

namespace tp::test {

using Bytes = std::string;

inline constexpr int kWidth = 3, kHeight = 2;

// Row by row from the top, RGB.
inline constexpr std::array<uint8_t, 18> kPixels = {255, 0,   0,   0, 255, 0, 0,   0,   255,
                                                    10,  100, 200, 0, 0,   0, 255, 255, 255};

inline Bytes big(uint32_t value, int count) {
    Bytes bytes;
    for (int i = count - 1; i >= 0; --i)
        bytes += static_cast<char>(value >> 8 * i & 0xff);
    return bytes;
}
inline Bytes little(uint32_t value, int count) {
    Bytes bytes;
    for (int i = 0; i < count; ++i)
        bytes += static_cast<char>(value >> 8 * i & 0xff);
    return bytes;
}
inline Bytes raw(std::initializer_list<int> values) {
    Bytes bytes;
    for (const int v : values)
        bytes += static_cast<char>(v);
    return bytes;
}
inline uint8_t pixel(int x, int y, int channel) {
    return kPixels[static_cast<size_t>(3 * (y * kWidth + x) + channel)];
}

// PNG: one chunk of data in a zlib stream of a single stored block (RFC 1950, 1951).
inline uint32_t crc32(const Bytes& bytes) {
    uint32_t crc = ~0u;
    for (const char byte : bytes) {
        crc ^= static_cast<uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1)));
    }
    return ~crc;
}
inline Bytes chunk(const Bytes& type, const Bytes& data) {
    return big(static_cast<uint32_t>(data.size()), 4) + type + data + big(crc32(type + data), 4);
}
inline Bytes stored_zlib(const Bytes& data) {
    uint32_t a = 1, b = 0;
    for (const char byte : data) {
        a = (a + static_cast<uint8_t>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    const auto size = static_cast<uint32_t>(data.size());
    return raw({0x78, 0x01, 0x01}) + little(size, 2) + little(~size, 2) + data +
           big(b << 16 | a, 4);
}
// `samples` are the rows without their filter bytes.
inline Bytes png(int bits, int color_type, const Bytes& samples, const Bytes& extra = {}) {
    Bytes rows;
    const size_t stride = samples.size() / kHeight;
    for (size_t y = 0; y < kHeight; ++y)
        rows += '\0' + samples.substr(y * stride, stride);
    const Bytes header = big(kWidth, 4) + big(kHeight, 4) + raw({bits, color_type, 0, 0, 0});
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + extra + chunk("IDAT", stored_zlib(rows)) +
           chunk("IEND", "");
}

// The picture's samples in file order: `channels` per pixel (a fourth is 128), `bytes` each.
inline Bytes samples(int channels, int bytes) {
    Bytes data;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            for (int c = 0; c < channels; ++c) {
                const int value = c < 3 ? pixel(x, y, c) : 128;
                for (int i = 0; i < bytes; ++i)
                    data += static_cast<char>(value);
            }
    return data;
}

// Rows of BMP and TGA stand upside down, as blue, green, red.
inline Bytes bottom_up_bgr(size_t row_multiple) {
    Bytes data;
    for (int y = kHeight - 1; y >= 0; --y) {
        for (int x = 0; x < kWidth; ++x)
            for (int c = 2; c >= 0; --c)
                data += static_cast<char>(pixel(x, y, c));
        while (data.size() % row_multiple != 0)
            data += '\0';
    }
    return data;
}

inline Bytes bmp() {
    const Bytes rows = bottom_up_bgr(4);
    return "BM" + little(static_cast<uint32_t>(54 + rows.size()), 4) + little(0, 4) +
           little(54, 4) + little(40, 4) + little(kWidth, 4) + little(kHeight, 4) + little(1, 2) +
           little(24, 2) + Bytes(24, '\0') + rows;
}
inline Bytes tga() {
    return raw({0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0}) + little(kWidth, 2) + little(kHeight, 2) +
           raw({24, 0}) + bottom_up_bgr(1);
}

// PSD: header, three empty sections, channel after channel.
inline Bytes psd(int bytes_per_channel) {
    Bytes file = "8BPS" + big(1, 2) + big(0, 4) + big(0, 2) + big(3, 2) + big(kHeight, 4) +
                 big(kWidth, 4) + big(static_cast<uint32_t>(8 * bytes_per_channel), 2) + big(3, 2) +
                 big(0, 4) + big(0, 4) + big(0, 4) + big(0, 2);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                for (int i = 0; i < bytes_per_channel; ++i)
                    file += static_cast<char>(pixel(x, y, c));
    return file;
}

// GIF: a palette of eight with one colour a pixel; codes of four bits, low half first: clear, the
// six pixels, end.
inline Bytes gif() {
    Bytes file = "GIF89a" + little(kWidth, 2) + little(kHeight, 2) + raw({0x82, 0, 0});
    file += Bytes(reinterpret_cast<const char*>(kPixels.data()), kPixels.size()) + Bytes(6, '\0');
    file += raw({0x2c, 0, 0, 0, 0}) + little(kWidth, 2) + little(kHeight, 2) + raw({0});
    file += raw({3, 4, 0x08, 0x21, 0x43, 0x95, 0, 0x3b});
    return file;
}

// Softimage PIC: one packet of plain red, green and blue.
inline Bytes pic() {
    return raw({0x53, 0x80, 0xf6, 0x34}) + Bytes(84, '\0') + "PICT" + big(kWidth, 2) +
           big(kHeight, 2) + big(0, 4) + big(3, 2) + big(0, 2) + raw({0, 8, 0, 0xe0}) +
           samples(3, 1);
}

}  // namespace tp::test
