// A CUDA device as a backend.
#include "cuda_kernels.cuh"
#include "film_resolve.h"

#include <teapath/core/error.h>
#include <teapath/device/cuda_buffer.cuh>
#include <teapath/device/cuda_scene.cuh>
#include <teapath/device/cuda_stream.cuh>
#include <teapath/render/backend.h>

#include <algorithm>

namespace tp {
namespace {

// Bytes for the sums of one launch; more blocks a launch mean a shorter tail.
constexpr size_t kLaunchBytes = size_t{256} << 20;
constexpr int64_t kMaxBlocksPerLaunch = 16;

// Makes `device` the current one, or says why it cannot.
void select_device(int device) {
    int count = 0;
    check(cudaGetDeviceCount(&count));
    if (device < 0 || device >= count) {
        throw Error(
            ErrorKind::Device,
            "there is no CUDA device " + std::to_string(device) + ", only " + std::to_string(count),
            "--device", "`teapath info` lists the devices");
    }
    check(cudaSetDevice(device));
}

std::string device_name(int device) {
    cudaDeviceProp properties;
    check(cudaGetDeviceProperties(&properties, device));
    return properties.name;
}

class CudaBackend final : public Backend {
public:
    explicit CudaBackend(int device) : name_(device_name(device)), invalid_(1) {
        invalid_.clear_to_zero(stream_.get());
    }

    std::string name() const override { return name_; }

    void upload(const SceneArrays& arrays, SceneParts parts) override {
        scene_.upload(arrays, parts, stream_);
        features_ = arrays.features | (arrays.brute_force ? kFeatureDebug : 0u);
        hittables_ = arrays.hittables;
        material_ids_ = arrays.material_ids;
        params_.scene = scene_.view();
        params_.camera = arrays.camera;
        params_.settings = arrays.settings;
        params_.key = tea_key(0, arrays.settings.seed, arrays.settings.key_rounds);
    }

    void reset_film(const FilmSetup& setup) override {
        setup_ = setup;
        params_.width = setup.width;
        params_.height = setup.height;
        samples_ = 0;
        pixels_ = static_cast<uint32_t>(setup.width) * static_cast<uint32_t>(setup.height);
        blocks_per_launch_ =
            std::clamp<int64_t>(static_cast<int64_t>(kLaunchBytes / (sizeof(BlockSum) * pixels_)),
                                1, kMaxBlocksPerLaunch);
        totals_.resize(pixels_);
        open_.resize(pixels_);
        feature_sums_.resize(setup.features ? pixels_ : 0);
        totals_.clear_to_zero(stream_.get());
        open_.clear_to_zero(stream_.get());
        feature_sums_.clear_to_zero(stream_.get());
    }

    bool render(const SampleRange& range, const std::atomic<bool>& cancel) override {
        const int64_t end = range.first + range.count;
        for (int64_t first = range.first; first < end && !cancel;) {
            const int64_t first_block = first / kBlockSamples;
            const int64_t last = std::min(end, (first_block + blocks_per_launch_) * kBlockSamples);
            render_blocks(first, last);
            stream_.wait();
            first = last;
        }
        if (cancel) return false;
        samples_ = end;
        counters_.samples += static_cast<uint64_t>(range.count) * pixels_;
        return true;
    }

    FilmImage read_film() override {
        std::vector<Total> totals(totals_.size());
        std::vector<BlockSum> open(open_.size());
        std::vector<FeatureSum> features(feature_sums_.size());
        totals_.download(totals.data(), stream_.get());
        open_.download(open.data(), stream_.get());
        feature_sums_.download(features.data(), stream_.get());
        std::vector<uint32_t> found;
        if (setup_.features) {
            DeviceBuffer<uint32_t> on_device(pixels_);
            launch_hittables(features_, params_, on_device.data(), stream_.get());
            found.resize(pixels_);
            on_device.download(found.data(), stream_.get());
        }
        return resolve_film(
            {make_span(std::as_const(totals)), make_span(std::as_const(open)),
             make_span(std::as_const(features)), make_span(std::as_const(found))},
            {make_span(std::as_const(hittables_)), make_span(std::as_const(material_ids_))},
            setup_.width, setup_.height, samples_);
    }

    std::vector<uint8_t> read_display(const DisplaySettings& display) override {
        DeviceBuffer<Rgb8> rgb(pixels_);
        launch_display(totals_.data(), open_.data(), pixels_, samples_, display, rgb.data(),
                       stream_.get());
        std::vector<uint8_t> bytes(size_t{3} * pixels_);
        rgb.download(reinterpret_cast<Rgb8*>(bytes.data()), stream_.get());
        return bytes;
    }

    size_t memory_bytes() const override {
        return scene_.bytes() + totals_.bytes() + open_.bytes() + feature_sums_.bytes() +
               sums_.bytes();
    }

    RenderCounters counters() const override {
        RenderCounters counters = counters_;
        unsigned long long invalid = 0;
        invalid_.download(&invalid, stream_.get());
        counters.invalid_samples = invalid;
        return counters;
    }

private:
    void render_blocks(int64_t first, int64_t last) {
        TraceLaunch launch;
        launch.first = first;
        launch.last = last;
        launch.first_block = first / kBlockSamples;
        launch.block_count =
            static_cast<int32_t>((last - 1) / kBlockSamples - launch.first_block + 1);
        if (sums_.size() < size_t{pixels_} * static_cast<size_t>(launch.block_count))
            sums_.resize(size_t{pixels_} * static_cast<size_t>(launch.block_count));
        launch.sums = sums_.data();
        launch.open = open_.data();
        launch.invalid = invalid_.data();
        launch_trace(features_, params_, launch, stream_.get());
        launch_fold(launch, pixels_, totals_.data(), open_.data(), stream_.get());
        if (setup_.features)
            launch_features(features_, params_, first, last, feature_sums_.data(), stream_.get());
    }

    std::string name_;
    Stream stream_;
    CudaScene scene_;
    LaunchParams params_;
    FilmSetup setup_;
    uint32_t features_ = 0;
    uint32_t pixels_ = 0;
    int64_t blocks_per_launch_ = 1;
    int64_t samples_ = 0;
    std::vector<Hittable> hittables_;  // for the ids of what a pixel shows
    std::vector<uint32_t> material_ids_;
    DeviceBuffer<Total> totals_;
    DeviceBuffer<BlockSum> open_;
    DeviceBuffer<BlockSum> sums_;
    DeviceBuffer<FeatureSum> feature_sums_;
    DeviceBuffer<unsigned long long> invalid_;
    RenderCounters counters_;
};

}  // namespace

std::unique_ptr<Backend> make_cuda_backend(int device) {
    select_device(device);
    return std::make_unique<CudaBackend>(device);
}

}  // namespace tp
