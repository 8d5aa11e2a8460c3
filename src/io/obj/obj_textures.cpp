#include "obj_textures.h"

#include <teapath/core/error.h>
#include <teapath/core/parallel.h>
#include <teapath/io/image_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace tp {
namespace fs = std::filesystem;

namespace {

double finite(double x, double otherwise) {
    return std::isfinite(x) ? x : otherwise;
}

// A channel as 8 bits.
uint8_t byte_of(const Image& image, size_t pixel, int channel) {
    const size_t at = pixel * static_cast<size_t>(image.channels) + static_cast<size_t>(channel);
    if (image.format == PixelFormat::U8) return static_cast<uint8_t>(image.bytes[at]);
    if (image.format == PixelFormat::U16) return static_cast<uint8_t>(image.bytes[2 * at + 1]);
    float value;
    std::copy_n(image.bytes.data() + 4 * at, 4, reinterpret_cast<std::byte*>(&value));
    return static_cast<uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255));
}

// RGBA of the first image (white where there is none), its alpha the second's first channel.
Image with_alpha(const Image* color, const Image& alpha) {
    Image image;
    image.width = color ? color->width : alpha.width;
    image.height = color ? color->height : alpha.height;
    image.channels = 4;
    const auto width = static_cast<size_t>(image.width), height = static_cast<size_t>(image.height);
    image.bytes.resize(width * height * 4);
    const auto alpha_width = static_cast<size_t>(alpha.width);
    for (size_t y = 0; y < height; ++y)
        for (size_t x = 0; x < width; ++x) {
            const size_t pixel = y * width + x;
            for (int c = 0; c < 3; ++c)
                image.bytes[pixel * 4 + static_cast<size_t>(c)] = static_cast<std::byte>(
                    color ? byte_of(*color, pixel, color->channels < 3 ? 0 : c) : 255);
            const size_t row = y * static_cast<size_t>(alpha.height) / height;
            const size_t column = x * alpha_width / width;
            // A file with an alpha of its own means that one.
            const int channel = alpha.channels % 2 == 0 ? alpha.channels - 1 : 0;
            image.bytes[pixel * 4 + 3] =
                static_cast<std::byte>(byte_of(alpha, row * alpha_width + column, channel));
        }
    return image;
}

}  // namespace

TextureId ObjTextures::add(const std::string& file, const tinyobj::texture_option_t& options,
                           ColorSpace space, Double3 tint, const std::string& alpha) {
    if (file.empty() && alpha.empty()) return {};
    const Double2 repeat(finite(options.scale[0], 1), finite(options.scale[1], 1));
    const Double2 offset(finite(options.origin_offset[0], 0), finite(options.origin_offset[1], 0));
    const auto [entry, is_new] = known_.try_emplace(
        fmt::format("{}\n{}\n{} {} {} {} {} {} {} {} {}", file, alpha, static_cast<int>(space),
                    repeat.x, repeat.y, offset.x, offset.y, options.clamp, tint.x, tint.y, tint.z));
    if (!is_new) return entry->second;
    Texture texture;
    texture.id = TextureId{static_cast<uint32_t>(content_.textures.size() + 1)};
    texture.kind = TextureKind::Image;
    texture.color_space = space;
    texture.wrap = options.clamp ? WrapMode::Clamp : WrapMode::Repeat;
    texture.repeat = repeat;
    // The file's v starts at the bottom: 1 - v becomes 1 - (scale v + offset).
    texture.uv_offset = Double2(offset.x, 1 - repeat.y - offset.y);
    texture.tint = tint;
    std::string path = file.empty() ? alpha : file;
    std::replace(path.begin(), path.end(), '\\', '/');
    texture.name = texture.part.path = paths_.add(path_piece(fs::path(path).stem().string()));
    texture.file.path = alpha.empty() ? path : path + "#with_alpha/" + alpha;
    entry->second = texture.id;
    content_.textures.push_back(std::move(texture));
    files_.push_back({file, alpha});
    return entry->second;
}

std::shared_ptr<const Image> ObjTextures::load(const Files& files) {
    const auto read = [&](const std::string& file) {
        const std::string bytes = read_beside(source_, file, "an image", source_.name);
        budget_.take(bytes);
        return read_image_from_memory(bytes, file);
    };
    if (files.alpha.empty()) return std::make_shared<const Image>(read(files.color));
    const Image alpha = read(files.alpha);
    if (files.color.empty()) return std::make_shared<const Image>(with_alpha(nullptr, alpha));
    const Image color = read(files.color);
    return std::make_shared<const Image>(with_alpha(&color, alpha));
}

void ObjTextures::load_images(ModelProgress& progress) {
    std::map<Files, std::shared_ptr<const Image>> images;
    for (const Files& files : files_)
        images.try_emplace(files);
    std::vector<decltype(images)::value_type*> wanted;
    for (auto& entry : images)
        wanted.push_back(&entry);
    std::vector<std::string> problems(wanted.size());
    progress.begin(0.5, wanted.size());
    shared_pool().for_each(static_cast<int64_t>(wanted.size()), [&](int64_t i) {
        const auto at = static_cast<size_t>(i);
        try {
            wanted[at]->second = load(wanted[at]->first);
        } catch (const Error& error) {
            const Files& files = wanted[at]->first;
            problems[at] =
                fmt::format("Image {} is missing: {}.",
                            files.color.empty() ? files.alpha : files.color, error.what());
        }
        progress.step();
    });
    for (std::string& problem : problems)
        if (!problem.empty()) content_.unsupported.push_back(std::move(problem));
    for (size_t i = 0; i < files_.size(); ++i)
        content_.textures[i].file.image = images[files_[i]];
}

bool ObjTextures::is_grey(TextureId id) const {
    if (!id) return false;
    const auto& image = content_.textures[id.value - 1].file.image;
    if (!image || image->channels < 3) return image != nullptr;
    const size_t pixels = static_cast<size_t>(image->width) * static_cast<size_t>(image->height);
    const size_t step = std::max<size_t>(pixels / 1000, 1);
    for (size_t i = 0; i < pixels; i += step)
        if (std::abs(byte_of(*image, i, 0) - byte_of(*image, i, 2)) > 8) return false;
    return true;
}

}  // namespace tp
