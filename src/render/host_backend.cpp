// The host's cores as a backend: tiles on a thread pool, path by path.
#include "film_resolve.h"
#include "variants.h"

#include <teapath/core/parallel.h>
#include <teapath/device/host_view.h>
#include <teapath/kernel/features.h>
#include <teapath/kernel/post.h>
#include <teapath/kernel/trace_pixel.h>
#include <teapath/render/backend.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace tp {
namespace {

constexpr int kTileSize = 16;

struct Tile {
    uint32_t x0, y0, x1, y1;
};

class HostBackend final : public Backend {
public:
    explicit HostBackend(int threads) : pool_(threads) {}

    BackendKind kind() const override { return BackendKind::Host; }

    std::string name() const override {
        const int threads = pool_.thread_count();
        return fmt::format("host, {} thread{}", threads, threads == 1 ? "" : "s");
    }

    void upload(const SceneArrays& arrays, SceneParts) override {
        arrays_ = arrays;
        params_.scene = host_view(arrays_, meshes_);
        params_.camera = arrays_.camera;
        params_.settings = arrays_.settings;
        params_.key = tea_key(0, arrays_.settings.seed, arrays_.settings.key_rounds);
    }

    void reset_film(const FilmSetup& setup) override {
        setup_ = setup;
        params_.width = setup.width;
        params_.height = setup.height;
        samples_ = 0;
        const size_t pixels = static_cast<size_t>(setup.width) * static_cast<size_t>(setup.height);
        totals_.assign(pixels, Total{});
        open_.assign(pixels, BlockSum{});
        features_.assign(setup.features ? pixels : 0, FeatureSum{});
    }

    bool render(const SampleRange& range, const std::atomic<bool>& cancel) override {
        std::atomic<uint64_t> rays = 0, invalid = 0;
        const int columns = (setup_.width + kTileSize - 1) / kTileSize;
        const int rows = (setup_.height + kTileSize - 1) / kTileSize;
        with_variant(arrays_.features, [&]<uint32_t kFeatures>() {
            pool_.for_each(int64_t{columns} * rows, [&](int64_t i) {
                if (cancel.load(std::memory_order_relaxed)) return;
                const RenderCounters tile = render_tile<kFeatures>(
                    tile_at(static_cast<int>(i % columns), static_cast<int>(i / columns)), range);
                rays += tile.rays;
                invalid += tile.invalid_samples;
            });
        });
        counters_.samples += static_cast<uint64_t>(range.count) * totals_.size();
        counters_.rays += rays;
        counters_.invalid_samples += invalid;
        samples_ = range.first + range.count;
        return !cancel;
    }

    FilmImage read_film() override {
        std::vector<uint32_t> hittables;
        if (setup_.features) hittables = hittables_at_centres();
        return resolve_film(
            {make_span(std::as_const(totals_)), make_span(std::as_const(open_)),
             make_span(std::as_const(features_)), make_span(std::as_const(hittables))},
            {params_.scene.hittables, params_.scene.material_ids}, setup_.width, setup_.height,
            samples_);
    }

    FilmImage read_guides(int64_t samples) override {
        std::vector<FeatureSum> sums(totals_.size());
        with_variant(arrays_.features, [&]<uint32_t kFeatures>() {
            pool_.for_each(setup_.height, [&](int64_t y) {
                for (int x = 0; x < setup_.width; ++x)
                    for (int64_t s = 0; s < samples; ++s)
                        add_features<kFeatures>(
                            params_, static_cast<uint32_t>(x), static_cast<uint32_t>(y),
                            static_cast<uint64_t>(s),
                            sums[static_cast<size_t>(y) * static_cast<size_t>(setup_.width) +
                                 static_cast<size_t>(x)]);
            });
        });
        return resolve_guides(make_span(std::as_const(sums)), setup_.width, setup_.height, samples);
    }

    std::vector<uint8_t> read_display(const DisplaySettings& display) override {
        std::vector<uint8_t> rgb(sizeof(Rgb8) * totals_.size());
        write_display(display, reinterpret_cast<Rgb8*>(rgb.data()), [](Rgb8 c) { return c; });
        return rgb;
    }

    DisplayImage display_image(const DisplaySettings& display) override {
        DisplayImage image{setup_.width, setup_.height, samples_, {}, nullptr};
        image.rgba.resize(sizeof(Rgba8) * totals_.size());
        write_display(display, reinterpret_cast<Rgba8*>(image.rgba.data()), opaque);
        return image;
    }

    size_t memory_bytes() const override {
        return arrays_.bytes() + totals_.size() * sizeof(Total) + open_.size() * sizeof(BlockSum) +
               features_.size() * sizeof(FeatureSum);
    }

    RenderCounters counters() const override { return counters_; }

private:
    Tile tile_at(int column, int row) const {
        const int x = column * kTileSize, y = row * kTileSize;
        return {static_cast<uint32_t>(x), static_cast<uint32_t>(y),
                static_cast<uint32_t>(std::min(x + kTileSize, setup_.width)),
                static_cast<uint32_t>(std::min(y + kTileSize, setup_.height))};
    }

    template <uint32_t kFeatures>
    RenderCounters render_tile(const Tile& tile, const SampleRange& range) {
        RenderCounters counters;
        for (uint32_t y = tile.y0; y < tile.y1; ++y) {
            for (uint32_t x = tile.x0; x < tile.x1; ++x) {
                const size_t pixel = static_cast<size_t>(y) * static_cast<size_t>(setup_.width) + x;
                render_pixel<kFeatures>(x, y, range, totals_[pixel], open_[pixel], counters);
                if (!setup_.features) continue;
                for (int64_t s = range.first; s < range.first + range.count; ++s)
                    add_features<kFeatures>(params_, x, y, static_cast<uint64_t>(s),
                                            features_[pixel]);
            }
        }
        return counters;
    }

    // Samples block by block; each full block is folded into the total.
    template <uint32_t kFeatures>
    void render_pixel(uint32_t x, uint32_t y, const SampleRange& range, Total& total,
                      BlockSum& open, RenderCounters& counters) {
        const int64_t end = range.first + range.count;
        for (int64_t first = range.first; first < end;) {
            const int64_t block_end = (first / kBlockSamples + 1) * kBlockSamples;
            const int64_t last = std::min(end, block_end);
            const TraceCounts counts = trace_pixel<kFeatures>(params_, x, y, first, last, open);
            counters.rays += counts.rays;
            counters.invalid_samples += counts.invalid;
            if (last == block_end) {
                fold_block(total, open);
                open = BlockSum{};
            }
            first = last;
        }
    }

    // The display pass: row by row into `pixels`, in the form that `pack` gives a colour.
    template <class Pixel, class Pack>
    void write_display(const DisplaySettings& display, Pixel* pixels, Pack&& pack) {
        const auto width = static_cast<size_t>(setup_.width);
        pool_.for_each(setup_.height, [&](int64_t y) {
            const size_t row = static_cast<size_t>(y) * width;
            for (size_t i = row; i < row + width; ++i)
                pixels[i] =
                    pack(display_color(mean_radiance(totals_[i], open_[i], samples_), display));
        });
    }

    std::vector<uint32_t> hittables_at_centres() {
        std::vector<uint32_t> found(totals_.size());
        with_variant(arrays_.features, [&]<uint32_t kFeatures>() {
            pool_.for_each(setup_.height, [&](int64_t y) {
                for (int x = 0; x < setup_.width; ++x)
                    found[static_cast<size_t>(y) * static_cast<size_t>(setup_.width) +
                          static_cast<size_t>(x)] =
                        hittable_at<kFeatures>(params_, static_cast<Real>(x) + Real(0.5),
                                               static_cast<Real>(y) + Real(0.5));
            });
        });
        return found;
    }

    ThreadPool pool_;
    SceneArrays arrays_;
    std::vector<MeshView> meshes_;
    LaunchParams params_;
    FilmSetup setup_;
    std::vector<Total> totals_;
    std::vector<BlockSum> open_;
    std::vector<FeatureSum> features_;
    int64_t samples_ = 0;
    RenderCounters counters_;
};

}  // namespace

std::unique_ptr<Backend> make_host_backend(int threads) {
    return std::make_unique<HostBackend>(threads);
}

}  // namespace tp
