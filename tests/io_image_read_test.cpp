// Image files of every format that textures may have, written byte by byte as their specifications
// say (JPEG, HDR and EXR by our own writer), read back to the pixel.
#include "support/image_bytes.h"

#include <teapath/core/error.h>
#include <teapath/io/image_file.h>

#include <doctest/doctest.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

using namespace tp;
using namespace tp::test;
namespace fs = std::filesystem;

namespace {

// A file of these bytes, read and removed.
Image read_bytes(const Bytes& bytes, const char* extension) {
    const fs::path file =
        fs::temp_directory_path() / ("teapath_image_" + std::to_string(getpid()) + extension);
    std::ofstream(file, std::ios::binary) << bytes;
    struct Remove {
        const fs::path& file;
        ~Remove() { fs::remove(file); }
    } remove{file};
    return read_image(file);
}

double value_at(const Image& image, int x, int y, int channel) {
    const auto i = static_cast<size_t>((y * image.width + x) * image.channels +
                                       std::min(channel, image.channels - 1));
    if (image.format == PixelFormat::U8) return static_cast<uint8_t>(image.bytes[i]);
    if (image.format == PixelFormat::U16) {
        uint16_t value;
        std::memcpy(&value, image.bytes.data() + 2 * i, 2);
        return value;
    }
    float value;
    std::memcpy(&value, image.bytes.data() + 4 * i, 4);
    return static_cast<double>(value);
}

// The picture of kPixels, its values multiplied by `scale`.
void check_picture(const Image& image, int channels, PixelFormat format, double scale = 1,
                   double tolerance = 0) {
    CHECK(image.width == kWidth);
    CHECK(image.height == kHeight);
    CHECK(image.channels == channels);
    CHECK(image.format == format);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            for (int c = 0; c < 3; ++c) {
                CAPTURE(x);
                CAPTURE(y);
                CAPTURE(c);
                CHECK(std::abs(value_at(image, x, y, c) - scale * pixel(x, y, c)) <= tolerance);
            }
}

Picture picture() {
    Picture p;
    p.width = kWidth;
    p.height = kHeight;
    ImageLayer layer{"", {"R", "G", "B"}, {}};
    for (const uint8_t value : kPixels) {
        p.display.push_back(value);
        layer.values.push_back(static_cast<float>(value));
    }
    p.linear = {layer};
    return p;
}

// The picture as our own writer has it.
Bytes bytes_written(const char* extension) {
    const fs::path file =
        fs::temp_directory_path() / ("teapath_written_" + std::to_string(getpid()) + extension);
    write_picture(file, picture());
    std::ifstream stream(file, std::ios::binary);
    const Bytes bytes{std::istreambuf_iterator<char>(stream), {}};
    fs::remove(file);
    return bytes;
}

}  // namespace

TEST_CASE("T18: PNG of 8 and 16 bits, grey, colour, palette, alpha") {
    check_picture(read_bytes(png(8, 2, samples(3, 1)), ".png"), 3, PixelFormat::U8);
    check_picture(read_bytes(png(16, 2, samples(3, 2)), ".png"), 3, PixelFormat::U16, 257);
    const Image rgba = read_bytes(png(8, 6, samples(4, 1)), ".png");
    check_picture(rgba, 4, PixelFormat::U8);
    CHECK(value_at(rgba, 2, 1, 3) == 128);
    const Image deep = read_bytes(png(16, 6, samples(4, 2)), ".png");
    check_picture(deep, 4, PixelFormat::U16, 257);
    CHECK(value_at(deep, 0, 0, 3) == 128 * 257);
    const Bytes palette(reinterpret_cast<const char*>(kPixels.data()), kPixels.size());
    check_picture(read_bytes(png(8, 3, raw({0, 1, 2, 3, 4, 5}), chunk("PLTE", palette)), ".png"), 3,
                  PixelFormat::U8);

    const Image grey = read_bytes(png(8, 0, raw({0, 1, 2, 3, 4, 255})), ".png");
    CHECK(grey.channels == 1);
    CHECK(value_at(grey, 2, 1, 0) == 255);
    const Image grey_alpha =
        read_bytes(png(8, 4, raw({0, 9, 1, 9, 2, 9, 3, 9, 4, 9, 255, 7})), ".png");
    CHECK(grey_alpha.channels == 2);
    CHECK(value_at(grey_alpha, 2, 1, 1) == 7);
    const Image grey16 = read_bytes(png(16, 0, raw({0, 1, 0, 2, 0, 3, 0, 4, 0, 5, 1, 2})), ".png");
    CHECK(grey16.format == PixelFormat::U16);
    CHECK(value_at(grey16, 2, 1, 0) == 258);
}

TEST_CASE("T18: BMP, TGA, PNM") {
    check_picture(read_bytes(bmp(), ".bmp"), 3, PixelFormat::U8);
    check_picture(read_bytes(tga(), ".tga"), 3, PixelFormat::U8);
    check_picture(read_bytes("P6\n# a comment\n3 2\n255\n" + samples(3, 1), ".ppm"), 3,
                  PixelFormat::U8);
    check_picture(read_bytes("P6 3 2 65535\n" + samples(3, 2), ".ppm"), 3, PixelFormat::U16, 257);
    const Image grey = read_bytes("P5 3 2 255\n" + raw({0, 1, 2, 3, 4, 255}), ".pgm");
    CHECK(grey.channels == 1);
    CHECK(value_at(grey, 2, 1, 0) == 255);
}

TEST_CASE("T18: PSD, GIF, PIC") {
    const auto check_opaque = [](const Image& image, PixelFormat format, double scale) {
        check_picture(image, image.channels, format, scale);
        if (image.channels == 4) CHECK(value_at(image, 1, 1, 3) == 255 * scale);
    };
    check_opaque(read_bytes(psd(1), ".psd"), PixelFormat::U8, 1);
    check_opaque(read_bytes(psd(2), ".psd"), PixelFormat::U16, 257);
    check_opaque(read_bytes(gif(), ".gif"), PixelFormat::U8, 1);
    check_opaque(read_bytes(pic(), ".pic"), PixelFormat::U8, 1);
}

TEST_CASE("T18: HDR and EXR are linear floats, JPEG is near enough") {
    // Flat RGBE: 255 is 255/256 * 2^8.
    const Bytes flat = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 3\n" +
                       raw({255, 0,   0,   136, 0, 255, 0, 136, 0,   0,   255, 136,
                            10,  100, 200, 136, 0, 0,   0, 0,   255, 255, 255, 136});
    check_picture(read_bytes(flat, ".hdr"), 3, PixelFormat::F32);
    check_picture(read_bytes(bytes_written(".hdr"), ".hdr"), 3, PixelFormat::F32, 1, 1);
    check_picture(read_bytes(bytes_written(".exr"), ".exr"), 3, PixelFormat::F32);
    const Image jpeg = read_bytes(bytes_written(".jpg"), ".jpg");
    CHECK(jpeg.width == kWidth);
    CHECK(jpeg.height == kHeight);
    CHECK(jpeg.channels == 3);
    CHECK(jpeg.format == PixelFormat::U8);
    CHECK(std::abs(value_at(jpeg, 2, 1, 0) - 255) < 60);
}

TEST_CASE("images: the extension does not matter, what is in the file does") {
    check_picture(read_bytes(png(8, 2, samples(3, 1)), ".jpg"), 3, PixelFormat::U8);
    check_picture(read_bytes(gif(), ".png"), 4, PixelFormat::U8);
}

TEST_CASE(
    "images: cut short or with wrong bytes they are refused, or give a picture; nothing crashes") {
    const auto survives = [](const Bytes& file) {
        try {
            const Image image = read_bytes(file, ".png");
            CHECK(image.bytes.size() ==
                  static_cast<size_t>(image.width * image.height * image.channels) *
                      (image.format == PixelFormat::U8    ? 1
                       : image.format == PixelFormat::U16 ? 2
                                                          : 4));
            return true;
        } catch (const Error& error) {
            CHECK(error.kind() == ErrorKind::Input);
            return false;
        }
    };
    uint32_t state = 1;
    const auto random = [&state](size_t below) {
        state = state * 1664525u + 1013904223u;
        return static_cast<size_t>((state >> 8) % below);
    };
    int refused = 0;
    for (const Bytes& file :
         {png(8, 2, samples(3, 1)), png(16, 6, samples(4, 2)), psd(1), psd(2), gif(), pic(), bmp(),
          tga(), bytes_written(".jpg"), bytes_written(".hdr"), bytes_written(".exr")}) {
        // Every length, or many of them; then one to four bytes changed, most of them in the
        // header.
        for (size_t length = 0; length < file.size(); length += 1 + file.size() / 200)
            refused += !survives(file.substr(0, length));
        for (int i = 0; i < 200; ++i) {
            Bytes wrong = file;
            for (size_t n = 1 + random(4); n > 0; --n)
                wrong[random(random(2) ? wrong.size() : std::min<size_t>(wrong.size(), 64))] =
                    static_cast<char>(random(256));
            refused += !survives(wrong);
        }
    }
    CHECK(refused > 1000);
}

TEST_CASE("images: a JPEG whose Huffman table has too many codes is refused") {
    const Bytes good = bytes_written(".jpg");
    const size_t table = good.find("\xff\xc4");
    REQUIRE(table != Bytes::npos);
    Bytes bad = good;
    for (size_t i = 5; i < 21; ++i)
        bad[table + i] = '\xff';
    CHECK(read_bytes(good, ".jpg").width == kWidth);
    CHECK_THROWS_AS(read_bytes(bad, ".jpg"), Error);
}
