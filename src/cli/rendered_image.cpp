#include "rendered_image.h"

#include "output_files.h"

#include <teapath/core/error.h>
#include <teapath/io/image_file.h>

#include <optional>
#include <utility>

namespace tp {
namespace {

// Adds a plane of the film as a layer, unless it is empty.
template <class Value>
void add_layer(Picture& picture, const std::string& name, std::vector<std::string> channels,
               const std::vector<Value>& values) {
    if (values.empty()) return;
    picture.linear.push_back({name, std::move(channels), {values.begin(), values.end()}});
}

ImageLayer beauty_layer(const FilmImage& film, bool with_alpha) {
    if (!with_alpha) return {"", {"R", "G", "B"}, film.radiance};
    ImageLayer layer{"", {"R", "G", "B", "A"}, {}};
    layer.values.reserve(film.alpha.size() * 4);
    for (size_t i = 0; i < film.alpha.size(); ++i) {
        layer.values.insert(layer.values.end(), {film.radiance[3 * i], film.radiance[3 * i + 1],
                                                 film.radiance[3 * i + 2], film.alpha[i]});
    }
    return layer;
}

// The film as the layers of an EXR file.
void add_all_layers(Picture& picture, const FilmImage& film) {
    picture.linear.push_back(beauty_layer(film, !film.alpha.empty()));
    add_layer(picture, "albedo", {"R", "G", "B"}, film.albedo);
    add_layer(picture, "normal", {"X", "Y", "Z"}, film.normal);
    add_layer(picture, "depth", {"Z"}, film.depth);
    add_layer(picture, "object_id", {"id"}, film.object_id);
    add_layer(picture, "material_id", {"id"}, film.material_id);
    add_layer(picture, "standard_error", {"Y"}, film.standard_error);
    const std::vector<float> counts(film.radiance.size() / 3, static_cast<float>(film.samples));
    add_layer(picture, "samples", {"count"}, counts);
}

Picture picture_for(const std::filesystem::path& file, const RenderedImage& image) {
    Picture picture{image.width, image.height, {}, {}, image.metadata};
    switch (content_of(file)) {
        case FileContent::Display: picture.display = image.display; break;
        case FileContent::Radiance:
            picture.linear.push_back(beauty_layer(image.film, false));
            break;
        case FileContent::Layers:
            add_all_layers(picture, image.film);
            picture.metadata.insert(image.run.begin(), image.run.end());
            break;
    }
    return picture;
}

}  // namespace

void write_files(const std::vector<std::filesystem::path>& files, const RenderedImage& image) {
    std::optional<Error> first_error;
    for (const std::filesystem::path& file : files) {
        try {
            write_picture(file, picture_for(file, image));
        } catch (const Error& error) {
            if (!first_error) first_error = error;
        }
    }
    if (first_error) throw *first_error;
}

}  // namespace tp
