#include "alias_table.h"

#include <teapath/core/color.h>
#include <teapath/core/parallel.h>
#include <teapath/device/environment_arrays.h>
#include <teapath/device/srgb_table.h>
#include <teapath/kernel/texture.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

namespace tp {
namespace {

constexpr uint32_t kMostColumns = 2048, kMostRows = 1024;

ImageRecord record_of(const Image& image, bool is_srgb) {
    ImageRecord record{};
    record.width = image.width;
    record.height = image.height;
    record.channels = static_cast<int16_t>(image.channels);
    record.bytes_per_channel = static_cast<uint8_t>(image.format == PixelFormat::U8    ? 1
                                                    : image.format == PixelFormat::U16 ? 2
                                                                                       : 4);
    record.is_srgb = is_srgb;
    return record;
}

// Luminance of every texel.
std::vector<float> luminances(const Image& image, bool is_srgb) {
    SceneView texels;
    texels.texels = reinterpret_cast<const unsigned char*>(image.bytes.data());
    texels.srgb_table = srgb_table().data();
    const ImageRecord record = record_of(image, is_srgb);
    const auto width = static_cast<size_t>(image.width);
    std::vector<float> values(width * static_cast<size_t>(image.height));
    parallel_for(image.height, 16, [&](int64_t first, int64_t last) {
        for (int64_t y = first; y < last; ++y)
            for (int x = 0; x < image.width; ++x) {
                const Vec4 c = load_texel(texels, record, x, static_cast<int>(y));
                const auto l = static_cast<float>(luminance(Vec3(c)));
                values[static_cast<size_t>(y) * width + static_cast<size_t>(x)] =
                    std::isfinite(l) && l > 0 ? l : 0;
            }
    });
    return values;
}

// The mean over the texels of a cell and those around it, which bilinear filtering mixes in.
double mean_around(const std::vector<float>& values, const Image& image, double x0, double x1,
                   double y0, double y1) {
    const int left = static_cast<int>(std::floor(x0)) - 1, right = static_cast<int>(std::ceil(x1));
    const int top = std::max(static_cast<int>(std::floor(y0)) - 1, 0);
    const int bottom = std::min(static_cast<int>(std::ceil(y1)), image.height - 1);
    double sum = 0;
    for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x) {
            const auto column = static_cast<size_t>(wrap_texel(x, image.width, WrapMode::Repeat));
            sum += static_cast<double>(
                values[static_cast<size_t>(y) * static_cast<size_t>(image.width) + column]);
        }
    return sum / ((right - left + 1) * (bottom - top + 1));
}

// Makes weights probabilities; all the same where there is no weight.
double normalize(std::vector<double>& weights) {
    double total = 0;
    for (const double w : weights)
        total += w;
    for (double& w : weights)
        w = total > 0 ? w / total : 1 / static_cast<double>(weights.size());
    return total;
}

void fill(EnvironmentCell* cells, const std::vector<double>& probability) {
    for (size_t i = 0; i < probability.size(); ++i)
        cells[i].probability = static_cast<Real>(probability[i]);
    fill_alias_table(cells, probability);
}

std::shared_ptr<const EnvironmentArrays> build(const Image& image, bool is_srgb) {
    const std::vector<float> values = luminances(image, is_srgb);
    auto arrays = std::make_shared<EnvironmentArrays>();
    arrays->width = std::min(static_cast<uint32_t>(image.width), kMostColumns);
    arrays->height = std::min(static_cast<uint32_t>(image.height), kMostRows);
    const size_t width = arrays->width, height = arrays->height;
    arrays->cells.resize(width * height);
    arrays->rows.resize(height);
    std::vector<double> row_weights(height);
    const double texels_x = image.width / static_cast<double>(width);
    const double texels_y = image.height / static_cast<double>(height);
    parallel_for(static_cast<int64_t>(height), 4, [&](int64_t first, int64_t last) {
        std::vector<double> weights(width);
        for (auto y = static_cast<size_t>(first); y < static_cast<size_t>(last); ++y) {
            const auto row = static_cast<double>(y);
            for (size_t x = 0; x < width; ++x) {
                const auto column = static_cast<double>(x);
                weights[x] = mean_around(values, image, column * texels_x, (column + 1) * texels_x,
                                         row * texels_y, (row + 1) * texels_y);
            }
            const double solid_angle =
                std::sin((row + 0.5) / static_cast<double>(height) * static_cast<double>(kPi));
            row_weights[y] = normalize(weights) * solid_angle;
            fill(arrays->cells.data() + y * width, weights);
        }
    });
    normalize(row_weights);
    fill(arrays->rows.data(), row_weights);
    return arrays;
}

// What has been made and is still held by somebody.
struct Cache {
    struct Entry {
        std::weak_ptr<const Image> image;  // tells a new image at the address of an old one
        std::weak_ptr<const EnvironmentArrays> arrays;
    };
    std::mutex mutex;
    std::map<std::pair<const Image*, bool>, Entry> entries;
};

Cache& cache() {
    static Cache all;
    return all;
}

}  // namespace

EnvironmentView EnvironmentArrays::view() const {
    return {make_span(rows), make_span(cells), width, height};
}

std::shared_ptr<const EnvironmentArrays> environment_of(const std::shared_ptr<const Image>& image,
                                                        bool is_srgb) {
    const std::lock_guard lock(cache().mutex);
    std::erase_if(cache().entries, [](const auto& e) { return e.second.arrays.expired(); });
    Cache::Entry& entry = cache().entries[{image.get(), is_srgb}];
    if (entry.image.lock() == image)
        if (auto arrays = entry.arrays.lock()) return arrays;
    auto arrays = build(*image, is_srgb);
    entry = {image, arrays};
    return arrays;
}

}  // namespace tp
