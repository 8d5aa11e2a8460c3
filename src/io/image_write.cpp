#include "exr_file.h"
#include "whole_file.h"

#include <teapath/core/error.h>
#include <teapath/io/image_file.h>

#include <fmt/format.h>
#include <stb/stb_image_write.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstring>

namespace tp {
namespace {

using Bytes = std::string;

void append(void* context, void* data, int size) {
    static_cast<Bytes*>(context)->append(static_cast<const char*>(data), static_cast<size_t>(size));
}

void append_big_endian(Bytes& out, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        out += static_cast<char>(value >> shift & 0xff);
}

// CRC-32 of PNG chunks (ISO 3309).
uint32_t crc32(std::string_view bytes) {
    uint32_t crc = 0xffffffffu;
    for (const char byte : bytes) {
        crc ^= static_cast<uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
}

Bytes png_chunk(const std::string& type, std::string_view data) {
    Bytes chunk;
    append_big_endian(chunk, static_cast<uint32_t>(data.size()));
    Bytes body = type;
    body.append(data);
    chunk += body;
    append_big_endian(chunk, crc32(body));
    return chunk;
}

Bytes write_png(const Picture& p) {
    Bytes png;
    if (!stbi_write_png_to_func(append, &png, p.width, p.height, 3, p.display.data(), 3 * p.width))
        return {};
    // The colour space and the metadata follow the header chunk, 8 + 25 bytes from the start.
    Bytes extra = png_chunk("sRGB", std::string_view("\0", 1));
    for (const auto& [key, value] : p.metadata) {
        Bytes text = key.substr(0, 79);
        text += '\0';
        text += Bytes("\0\0\0\0", 4);  // not compressed; no language, no translated key
        text += value;
        extra += png_chunk("iTXt", text);
    }
    png.insert(33, extra);
    return png;
}

// Metadata as "key: value" lines.
Bytes metadata_lines(const Picture& p, const char* prefix) {
    Bytes lines;
    for (const auto& [key, value] : p.metadata) {
        Bytes line = fmt::format("{}{}: {}", prefix, key, value);
        std::replace(line.begin(), line.end(), '\n', ' ');
        lines += line + "\n";
    }
    return lines;
}

Bytes write_jpeg(const Picture& p) {
    Bytes jpeg;
    if (!stbi_write_jpg_to_func(append, &jpeg, p.width, p.height, 3, p.display.data(), 95))
        return {};
    // A comment segment after the start marker.
    Bytes comment = metadata_lines(p, "").substr(0, 65000);
    const auto length = static_cast<uint32_t>(comment.size() + 2);
    Bytes segment = {'\xff', '\xfe', static_cast<char>(length >> 8),
                     static_cast<char>(length & 0xff)};
    jpeg.insert(2, segment + comment);
    return jpeg;
}

Bytes write_bmp(const Picture& p) {
    Bytes bmp;
    return stbi_write_bmp_to_func(append, &bmp, p.width, p.height, 3, p.display.data()) ? bmp
                                                                                        : Bytes{};
}

Bytes write_tga(const Picture& p) {
    Bytes tga;
    if (!stbi_write_tga_to_func(append, &tga, p.width, p.height, 3, p.display.data())) return {};
    // The "image ID" after the header of 18 bytes holds 255; the header's first byte is its length.
    const Bytes id = metadata_lines(p, "").substr(0, 255);
    tga[0] = static_cast<char>(id.size());
    tga.insert(18, id);
    return tga;
}

Bytes write_ppm_binary(const Picture& p) {
    Bytes ppm = "P6\n" + metadata_lines(p, "# ") + fmt::format("{} {}\n255\n", p.width, p.height);
    ppm.append(reinterpret_cast<const char*>(p.display.data()), p.display.size());
    return ppm;
}

Bytes write_ppm_text(const Picture& p) {
    Bytes ppm = "P3\n" + metadata_lines(p, "# ") + fmt::format("{} {}\n255\n", p.width, p.height);
    for (size_t i = 0; i < p.display.size(); i += 3)
        ppm += fmt::format("{} {} {}\n", p.display[i], p.display[i + 1], p.display[i + 2]);
    return ppm;
}

// The picture's radiance as three channels.
std::vector<float> linear_rgb(const Picture& p) {
    const ImageLayer& layer = p.linear.front();
    const size_t channels = layer.channels.size(),
                 pixels = static_cast<size_t>(p.width) * static_cast<size_t>(p.height);
    std::vector<float> rgb(3 * pixels);
    for (size_t i = 0; i < pixels; ++i)
        for (size_t c = 0; c < 3; ++c)
            rgb[3 * i + c] = layer.values[channels * i + std::min(c, channels - 1)];
    return rgb;
}

Bytes write_hdr(const Picture& p) {
    Bytes hdr;
    const std::vector<float> rgb = linear_rgb(p);
    if (!stbi_write_hdr_to_func(append, &hdr, p.width, p.height, 3, rgb.data())) return {};
    const size_t first_line = hdr.find('\n') + 1;
    hdr.insert(first_line, metadata_lines(p, "# "));
    return hdr;
}

// Portable float map: rows from the bottom up, a negative scale says little endian.
Bytes write_pfm(const Picture& p) {
    static_assert(std::endian::native == std::endian::little);
    const std::vector<float> rgb = linear_rgb(p);
    Bytes pfm = fmt::format("PF\n{} {}\n-1.0\n", p.width, p.height);
    const size_t row = 3 * static_cast<size_t>(p.width);
    for (int y = p.height - 1; y >= 0; --y)
        pfm.append(reinterpret_cast<const char*>(rgb.data() + static_cast<size_t>(y) * row),
                   row * sizeof(float));
    return pfm;
}

struct Format {
    const char* extension;
    Bytes (*write)(const Picture&);
};

// The longer extension first.
constexpr std::array kFormats = {
    Format{".p3.ppm", write_ppm_text}, Format{".ppm", write_ppm_binary}, Format{".png", write_png},
    Format{".jpeg", write_jpeg},       Format{".jpg", write_jpeg},       Format{".bmp", write_bmp},
    Format{".tga", write_tga},         Format{".hdr", write_hdr},        Format{".pfm", write_pfm},
    Format{".exr", write_exr}};

const Format* format_of(const std::filesystem::path& file) {
    std::string name = file.filename().string();
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const Format& format : kFormats)
        if (name.ends_with(format.extension)) return &format;
    return nullptr;
}

}  // namespace

bool can_write_image(const std::filesystem::path& file) {
    return format_of(file) != nullptr;
}

void write_picture(const std::filesystem::path& file, const Picture& picture) {
    const Format* format = format_of(file);
    if (!format)
        throw Error(ErrorKind::Usage,
                    fmt::format("the extension \"{}\" names no format that can be written",
                                file.extension().string()),
                    file.string(), "known: .png .jpg .bmp .tga .ppm .p3.ppm .hdr .pfm .exr");
    Bytes bytes;
    try {
        bytes = format->write(picture);
    } catch (const std::exception& error) {
        throw Error(ErrorKind::Output,
                    fmt::format("the picture cannot be encoded: {}", error.what()), file.string(),
                    "try another format");
    }
    if (bytes.empty())
        throw Error(ErrorKind::Output, "the picture cannot be encoded", file.string(),
                    "try another format");
    write_whole_file(file, bytes);
}

}  // namespace tp
