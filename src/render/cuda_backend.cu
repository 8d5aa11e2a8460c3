// A CUDA device as a backend.
#include "cuda_kernels.cuh"
#include "film_resolve.h"

#include <teapath/core/error.h>
#include <teapath/device/cuda_buffer.cuh>
#include <teapath/device/cuda_scene.cuh>
#include <teapath/device/cuda_stream.cuh>
#include <teapath/device/device_image.cuh>
#include <teapath/render/backend.h>

#include <algorithm>

namespace tp {
namespace {

// Bytes for the sums of one launch; more blocks a launch mean a shorter tail.
constexpr size_t kLaunchBytes = size_t{256} << 20;
constexpr int64_t kMaxBlocksPerLaunch = 16;
// A window's film shrinks to an eighth in both directions while something moves, and grows again.
constexpr size_t kFilmSlack = 64;
// Groups of threads in a launch at least: fewer would leave multiprocessors without work.
constexpr double kLeastGroups = 128;

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
    CudaBackend(int device, double launch_seconds)
        : device_(device),
          name_(device_name(device)),
          launch_seconds_(launch_seconds),
          count_sums_(1) {
        count_sums_.clear_to_zero(stream_.get());
    }

    BackendKind kind() const override { return BackendKind::Cuda; }

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
        blocks_per_launch_ = std::clamp<int64_t>(
            static_cast<int64_t>(kLaunchBytes /
                                 ((sizeof(BlockSum) + sizeof(TraceCounts)) * pixels_)),
            1, kMaxBlocksPerLaunch);
        totals_.resize(pixels_, kFilmSlack);
        open_.resize(pixels_, kFilmSlack);
        feature_sums_.resize(setup.features ? pixels_ : 0, kFilmSlack);
        totals_.clear_to_zero(stream_.get());
        open_.clear_to_zero(stream_.get());
        feature_sums_.clear_to_zero(stream_.get());
    }

    bool render(const SampleRange& range, const std::atomic<bool>& cancel) override {
        const int64_t end = range.first + range.count;
        for (int64_t first = range.first; first < end && !cancel;) {
            const int64_t first_block = first / kBlockSamples;
            const int64_t last = std::min(end, (first_block + blocks_per_launch_) * kBlockSamples);
            if (!render_blocks(first, last, cancel)) return false;
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

    FilmImage read_guides(int64_t samples) override {
        DeviceBuffer<FeatureSum> on_device(pixels_);
        on_device.clear_to_zero(stream_.get());
        launch_features(features_, params_, 0, samples, on_device.data(), stream_.get());
        std::vector<FeatureSum> sums(pixels_);
        on_device.download(sums.data(), stream_.get());
        return resolve_guides(make_span(std::as_const(sums)), setup_.width, setup_.height, samples);
    }

    std::vector<uint8_t> read_display(const DisplaySettings& display) override {
        DeviceBuffer<Rgb8> rgb(pixels_);
        launch_display(totals_.data(), open_.data(), pixels_, samples_, display, rgb.data(),
                       stream_.get());
        std::vector<uint8_t> bytes(size_t{3} * pixels_);
        rgb.download(reinterpret_cast<Rgb8*>(bytes.data()), stream_.get());
        return bytes;
    }

    DisplayImage display_image(const DisplaySettings&) override {
        const std::shared_ptr<DeviceImage> image = free_image();
        image->shown.hold(stream_);
        image->radiance.resize(pixels_, kFilmSlack);
        launch_mean(totals_.data(), open_.data(), pixels_, samples_, image->radiance.data(),
                    stream_.get());
        image->filled.record(stream_);
        return {setup_.width, setup_.height, samples_, {}, image};
    }

    size_t memory_bytes() const override {
        size_t bytes = scene_.bytes() + totals_.allocated_bytes() + open_.allocated_bytes() +
                       feature_sums_.allocated_bytes() + sums_.allocated_bytes() +
                       counts_.allocated_bytes();
        for (const auto& image : images_)
            bytes += image->radiance.allocated_bytes();
        return bytes;
    }

    RenderCounters counters() const override {
        RenderCounters counters = counters_;
        LaunchCounts counts{};
        count_sums_.download(&counts, stream_.get());
        counters.invalid_samples = counts.invalid;
        counters.rays = counts.rays;
        return counters;
    }

private:
    // A picture that nobody but this backend holds; there are as many as are shown at once, and
    // one.
    std::shared_ptr<DeviceImage> free_image() {
        for (const auto& image : images_)
            if (image.use_count() == 1) return image;
        images_.push_back(std::make_shared<DeviceImage>());
        images_.back()->device = device_;
        return images_.back();
    }

    // Traces samples [first, last) of every pixel and folds them into the film; waits for it. False
    // if cancelled on the way.
    bool render_blocks(int64_t first, int64_t last, const std::atomic<bool>& cancel) {
        TraceLaunch launch;
        launch.first = first;
        launch.last = last;
        launch.first_block = first / kBlockSamples;
        launch.block_count =
            static_cast<int32_t>((last - 1) / kBlockSamples - launch.first_block + 1);
        const size_t sums = size_t{pixels_} * static_cast<size_t>(launch.block_count);
        if (sums_.size() < sums) sums_.resize(sums);
        if (counts_.size() < sums) counts_.resize(sums);
        launch.sums = sums_.data();
        launch.open = open_.data();
        launch.counts = counts_.data();
        if (!trace(launch, cancel)) return false;
        launch_fold(launch, pixels_, totals_.data(), open_.data(), count_sums_.data(),
                    stream_.get());
        if (setup_.features)
            launch_features(features_, params_, first, last, feature_sums_.data(), stream_.get());
        stream_.wait();
        return true;
    }

    // The whole picture in launches that each keep the device for about launch_seconds_. Two are
    // under way at a time, so that it has no pause; each measures the rate for the next.
    bool trace(TraceLaunch launch, const std::atomic<bool>& cancel) {
        const uint32_t groups = groups_for(setup_.width, setup_.height);
        const double work = static_cast<double>(launch.last - launch.first);  // of one group
        for (uint32_t n = 0, first = 0; first < groups; ++n) {
            LaunchTime& time = times_[n % 2];
            if (n >= 2) measure(time);
            if (cancel) break;
            launch.first_group = first;
            launch.group_count = groups - first;
            if (launch_seconds_ > 0) {
                const double fitting = launch_seconds_ * groups_per_second_ / work;
                launch.group_count = static_cast<uint32_t>(std::min(
                    static_cast<double>(launch.group_count), std::max(fitting, kLeastGroups)));
            }
            time.work = work * launch.group_count;
            time.start.record(stream_);
            launch_trace(features_, params_, launch, stream_.get());
            time.end.record(stream_);
            first += launch.group_count;
            if (first >= groups) measure(time);
        }
        if (cancel) stream_.wait();
        return !cancel;
    }

    // A launch on the device: when it began and ended, and samples of a group in it.
    struct LaunchTime {
        Event start, end;
        double work = 0;
    };

    void measure(const LaunchTime& time) {
        if (launch_seconds_ <= 0) return;
        time.end.wait();
        const double seconds = static_cast<double>(time.end.milliseconds_since(time.start)) * 1e-3;
        if (seconds > 1e-5) groups_per_second_ = time.work / seconds;
    }

    int device_;
    std::string name_;
    Stream stream_;
    std::vector<std::shared_ptr<DeviceImage>> images_;  // given out by display_image
    CudaScene scene_;
    LaunchParams params_;
    FilmSetup setup_;
    double launch_seconds_;
    double groups_per_second_ = 4e5;  // samples of kTraceThreads pixels, as last measured
    LaunchTime times_[2];
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
    DeviceBuffer<TraceCounts> counts_;
    DeviceBuffer<LaunchCounts> count_sums_;
    RenderCounters counters_;
};

}  // namespace

std::unique_ptr<Backend> make_cuda_backend(int device, double launch_seconds) {
    select_device(device);
    return std::make_unique<CudaBackend>(device, launch_seconds);
}

}  // namespace tp
