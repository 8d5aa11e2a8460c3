// A finished render on its way to files.
#pragma once

#include <teapath/render/film_image.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tp {

struct RenderedImage {
    int width = 0;
    int height = 0;
    FilmImage film;                // empty if no file holds radiance
    std::vector<uint8_t> display;  // RGB; empty if no file holds bytes

    std::map<std::string, std::string> metadata;  // the same for each run of the same render
    std::map<std::string, std::string> run;  // of this run, such as its time; EXR only, so that
                                             // the other files are the same byte for byte
};

/// Writes every file, each whole or not at all. If one fails, the others are still written, then
/// its Error is thrown.
void write_files(const std::vector<std::filesystem::path>& files, const RenderedImage& image);

}  // namespace tp
