// Image files: reading textures and backgrounds, writing renders.
#pragma once

#include <teapath/core/span.h>
#include <teapath/scene/image.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// Reads JPEG, PNG, WebP, TGA, BMP, PSD, GIF, HDR, PIC, PNM, EXR with the bit depth of the file.
/// Throws Error(Input).
Image read_image(const std::filesystem::path& file);

/// The same from the bytes of a file; `name` stands for it in messages.
Image read_image_from_memory(std::string_view bytes, const std::string& name);

/// Bytes that its pixels will take, by its header; 0 if that is damaged.
uint64_t bytes_of_image(std::string_view bytes);

/// One named plane of a render, float, row-major, top row first.
struct ImageLayer {
    std::string name;                   // "" = the picture itself, else e.g. "albedo"
    std::vector<std::string> channels;  // e.g. {"R", "G", "B", "A"} or {"X", "Y", "Z"}
    std::vector<float> values;          // width * height * channels, interleaved
};

/// A finished picture on its way to a file.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<ImageLayer> linear;  // linear radiance: EXR (all layers), HDR, PFM (the first)
    std::vector<uint8_t> display;    // RGB after the tone curve: PNG, JPEG, BMP, TGA, PPM
    std::map<std::string, std::string>
        metadata;  // seed, settings, program; where the format has it
};

/// True if the extension (lower or upper case) names a format that can be written.
bool can_write_image(const std::filesystem::path& file);

/// Writes whole or not at all, in the format of the extension: .png .jpg .jpeg .bmp .tga .ppm (P6)
/// .p3.ppm (P3) .hdr .pfm .exr. Throws Error(Output), Error(Usage) for an unknown extension.
void write_picture(const std::filesystem::path& file, const Picture& picture);

}  // namespace tp
