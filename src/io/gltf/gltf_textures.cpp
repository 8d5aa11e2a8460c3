#include "gltf_textures.h"

#include "gltf_value.h"

#include <teapath/core/error.h>
#include <teapath/core/parallel.h>
#include <teapath/io/image_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace tp {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;

void add_transform(TextureUse& use, const tinygltf::Value* transform) {
    if (!transform) return;
    use.offset = vector_in(*transform, "offset", use.offset);
    use.repeat = vector_in(*transform, "scale", use.repeat);
    use.rotation = number_in(*transform, "rotation", 0);
    use.uv_set = index_in(*transform, "texCoord", use.uv_set);
}

WrapMode wrap_of(int mode) {
    return mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? WrapMode::Clamp
           : mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? WrapMode::Mirror
                                                           : WrapMode::Repeat;
}

WrapModeV wrap_v_of(WrapMode mode) {
    return mode == WrapMode::Clamp    ? WrapModeV::Clamp
           : mode == WrapMode::Mirror ? WrapModeV::Mirror
                                      : WrapModeV::Repeat;
}

// Grey: 1 - factor * alpha, which is 1 where the image has none.
std::shared_ptr<const Image> roughness_of(const Image& image, double factor) {
    auto changed = std::make_shared<Image>();
    changed->width = image.width;
    changed->height = image.height;
    changed->channels = 3;
    const auto channels = static_cast<size_t>(image.channels);
    const size_t depth = image.format == PixelFormat::U8    ? 1
                         : image.format == PixelFormat::U16 ? 2
                                                            : 4;
    const size_t pixels = static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
    changed->bytes.resize(pixels * 3);
    for (size_t i = 0; i < pixels; ++i) {
        unsigned glossiness = 255;
        // Whole numbers only; of 16 bits the upper half, as little-endian machines hold it.
        if (channels % 2 == 0 && depth < 4)
            glossiness = static_cast<unsigned>(
                image.bytes[(i * channels + channels - 1) * depth + depth - 1]);
        const auto roughness = static_cast<std::byte>(std::lround(255 - factor * glossiness));
        for (size_t c = 0; c < 3; ++c)
            changed->bytes[i * 3 + c] = roughness;
    }
    return changed;
}

}  // namespace

TextureUse use_of(const tinygltf::TextureInfo& info) {
    TextureUse use;
    use.index = info.index;
    use.uv_set = info.texCoord;
    add_transform(use, find_extension(info.extensions, "KHR_texture_transform"));
    return use;
}

TextureUse use_of(const tinygltf::NormalTextureInfo& info) {
    TextureUse use;
    use.index = info.index;
    use.uv_set = info.texCoord;
    use.scale = info.scale;
    add_transform(use, find_extension(info.extensions, "KHR_texture_transform"));
    return use;
}

TextureUse use_in(const tinygltf::Value& object, const char* key) {
    TextureUse use;
    const tinygltf::Value* info = find_value(object, key);
    if (!info || !info->IsObject()) return use;
    use.index = index_in(*info, "index", -1);
    use.uv_set = index_in(*info, "texCoord", 0);
    use.scale = number_in(*info, "scale", 1);
    if (const tinygltf::Value* extensions = find_value(*info, "extensions"))
        add_transform(use, find_value(*extensions, "KHR_texture_transform"));
    return use;
}

// A WebP image stands beside one for programs that cannot read it.
int GltfTextures::image_of(const tinygltf::Texture& texture) const {
    if (const auto* webp = find_extension(texture.extensions, "EXT_texture_webp"))
        return index_in(*webp, "source", texture.source);
    return texture.source;
}

TextureId GltfTextures::add(const TextureUse& use, ColorSpace space, const std::string& where,
                            Double3 tint, double glossiness) {
    if (use.index < 0) return {};
    const auto& textures = document_.model.textures;
    if (static_cast<size_t>(use.index) >= textures.size())
        throw Error(ErrorKind::Input, fmt::format("there is no texture {}", use.index), where,
                    "export the model again");
    const auto [entry, is_new] = known_.try_emplace(
        Key{use.index, static_cast<int>(space), use.offset.x, use.offset.y, use.repeat.x,
            use.repeat.y, use.rotation, use.uv_set, tint.x, tint.y, tint.z, glossiness});
    if (!is_new) return entry->second;

    const tinygltf::Texture& source = textures[static_cast<size_t>(use.index)];
    const int image = image_of(source);
    if (image >= static_cast<int>(document_.images.size()))
        throw Error(ErrorKind::Input, fmt::format("there is no image {}", image),
                    document_.place("textures", static_cast<size_t>(use.index)),
                    "export the model again");
    Texture texture;
    texture.id = TextureId{static_cast<uint32_t>(content_.textures.size() + 1)};
    texture.kind = TextureKind::Image;
    texture.color_space = space;
    texture.uv_set = std::min(std::max(use.uv_set, 0), 1);
    texture.repeat = use.repeat;
    texture.uv_rotation = use.rotation * kDegrees;
    texture.uv_offset = use.offset;
    texture.tint = tint;
    if (use.uv_set > 1 && said_.insert("uv sets").second)
        content_.unsupported.push_back(
            "A texture uses a set of texture coordinates beyond the second; the second is taken.");

    // Name: the image's, its file's, or its number.
    std::string name = fmt::format("image {}", image);
    if (image >= 0) {
        const GltfImage& stored = document_.images[static_cast<size_t>(image)];
        texture.file.path =
            stored.uri.empty()
                ? fmt::format("{}#image/{}",
                              std::filesystem::path(document_.source->name).filename().string(),
                              image)
                : stored.uri;
        if (!stored.name.empty())
            name = stored.name;
        else if (!stored.uri.empty())
            name = std::filesystem::path(stored.uri).stem().string();
    }
    if (glossiness >= 0) {
        name += " roughness";
        texture.file.path +=
            texture.file.path.find('#') == std::string::npos ? "#roughness" : "/roughness";
    }
    texture.name = texture.part.path = paths_.add(path_piece(name));

    if (source.sampler >= 0) {
        if (static_cast<size_t>(source.sampler) >= document_.model.samplers.size())
            throw Error(ErrorKind::Input, fmt::format("there is no sampler {}", source.sampler),
                        document_.place("textures", static_cast<size_t>(use.index)),
                        "export the model again");
        const auto& sampler = document_.model.samplers[static_cast<size_t>(source.sampler)];
        texture.wrap = wrap_of(sampler.wrapS);
        if (const WrapMode v = wrap_of(sampler.wrapT); v != texture.wrap)
            texture.wrap_v = wrap_v_of(v);
        if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST)
            texture.filter = FilterMode::Nearest;
    }
    entry->second = texture.id;
    content_.textures.push_back(std::move(texture));
    sources_.push_back({image, glossiness});
    return entry->second;
}

std::shared_ptr<const Image> GltfTextures::load(size_t index) {
    const GltfImage& image = document_.images[index];
    const std::string where = document_.place("images", index);
    std::string file;
    std::string_view bytes;
    if (image.bytes)
        bytes = *image.bytes;
    else if (!image.uri.empty())
        bytes = file = read_beside(*document_.source, image.uri, "an image", where);
    else
        bytes = bytes_of_view(document_, image.view, where);
    budget_.take(bytes);
    return std::make_shared<const Image>(read_image_from_memory(bytes, where));
}

void GltfTextures::load_images(ModelProgress& progress) {
    // Each image once, however many textures show it.
    std::vector<int> wanted;
    std::map<int, std::shared_ptr<const Image>> images;
    for (const Source& source : sources_)
        if (images.try_emplace(source.image).second && source.image >= 0)
            wanted.push_back(source.image);
    std::vector<std::string> problems(wanted.size());
    std::vector<std::shared_ptr<const Image>> loaded(wanted.size());
    shared_pool().for_each(static_cast<int64_t>(wanted.size()), [&](int64_t i) {
        const auto at = static_cast<size_t>(i);
        try {
            loaded[at] = load(static_cast<size_t>(wanted[at]));
        } catch (const Error& error) {
            problems[at] = fmt::format("Image {} is missing: {} ({}).", wanted[at], error.what(),
                                       error.where());
        }
        progress.step();
    });
    for (size_t i = 0; i < wanted.size(); ++i) {
        images[wanted[i]] = loaded[i];
        if (!problems[i].empty()) content_.unsupported.push_back(problems[i]);
    }
    if (images.contains(-1))
        content_.unsupported.push_back("A texture has no image in a format that can be read.");

    // A changed image once too.
    std::map<std::pair<int, double>, std::shared_ptr<const Image>> changed;
    for (size_t i = 0; i < sources_.size(); ++i) {
        std::shared_ptr<const Image> image = images[sources_[i].image];
        if (image && sources_[i].glossiness >= 0) {
            auto& entry = changed[{sources_[i].image, sources_[i].glossiness}];
            if (!entry) entry = roughness_of(*image, sources_[i].glossiness);
            image = entry;
        }
        content_.textures[i].file.image = image;
    }
}

}  // namespace tp
