#include "oidn_library.h"

#include <teapath/core/error.h>
#include <teapath/denoise/denoiser.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr const char* kRemedy =
    "./run fetches it with the network there; or name its folder in TEAPATH_OIDN";

const OidnLibrary& library() {
    std::string why;
    if (const OidnLibrary* found = oidn_library(why)) return *found;
    throw Error(ErrorKind::Device, "no denoiser: " + why, "Open Image Denoise", kRemedy);
}

}  // namespace

struct Denoiser::State {
    const OidnLibrary& oidn = library();
    OidnDeviceHandle* device = nullptr;
    bool is_gpu = false;
    int width = 0, height = 0;
    OidnBufferHandle *color = nullptr, *albedo = nullptr, *normal = nullptr, *output = nullptr;

    explicit State(bool on_gpu) {
        if (on_gpu) device = started(kOidnCuda);
        is_gpu = device != nullptr;
        if (!device) device = started(kOidnCpu);
        if (!device)
            throw Error(ErrorKind::Device, "no denoiser: it has no device here",
                        "Open Image Denoise", kRemedy);
    }
    ~State() {
        release_buffers();
        oidn.release_device(device);
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    // Null where there is no such device.
    OidnDeviceHandle* started(int type) const {
        OidnDeviceHandle* made = oidn.new_device(type);
        if (!made) {
            const char* ignored = nullptr;
            oidn.device_error(nullptr, &ignored);
            return nullptr;
        }
        oidn.commit_device(made);
        const char* ignored = nullptr;
        if (oidn.device_error(made, &ignored) == 0) return made;
        oidn.release_device(made);
        return nullptr;
    }

    void check() const {
        const char* message = nullptr;
        if (oidn.device_error(device, &message) == 0) return;
        throw Error(ErrorKind::Device,
                    fmt::format("the picture could not be denoised: {}",
                                message ? message : "an error without a name"),
                    "Open Image Denoise", "a smaller picture takes less memory");
    }

    void release_buffers() {
        for (OidnBufferHandle** buffer : {&color, &albedo, &normal, &output}) {
            if (*buffer) oidn.release_buffer(*buffer);
            *buffer = nullptr;
        }
        width = height = 0;
    }

    size_t bytes() const {
        return 3 * sizeof(float) * static_cast<size_t>(width) * static_cast<size_t>(height);
    }

    void resize(int new_width, int new_height) {
        if (width == new_width && height == new_height) return;
        release_buffers();
        const size_t size =
            3 * sizeof(float) * static_cast<size_t>(new_width) * static_cast<size_t>(new_height);
        for (OidnBufferHandle** buffer : {&color, &albedo, &normal, &output}) {
            *buffer = oidn.new_buffer(device, size);
            check();
        }
        width = new_width;
        height = new_height;
    }

    void write(OidnBufferHandle* buffer, std::span<const float> values, float low, float high) {
        std::vector<float> clean(values.begin(), values.end());
        for (float& v : clean)
            v = std::isfinite(v) ? std::clamp(v, low, high) : 0.0f;
        oidn.write_buffer(buffer, 0, bytes(), clean.data());
    }

    void set_image(OidnFilterHandle* filter, const char* name, OidnBufferHandle* buffer) const {
        oidn.set_image(filter, name, buffer, kOidnFloat3, static_cast<size_t>(width),
                       static_cast<size_t>(height), 0, 0, 0);
    }

    void execute(OidnFilterHandle* filter, DenoiseQuality quality) const {
        oidn.set_int(filter, "quality",
                     quality == DenoiseQuality::Final ? kOidnQualityHigh : kOidnQualityFast);
        oidn.commit_filter(filter);
        oidn.execute_filter(filter);
        oidn.release_filter(filter);
        check();
    }

    // Takes the noise of a feature away in place.
    void prefilter(const char* name, OidnBufferHandle* buffer, DenoiseQuality quality) const {
        OidnFilterHandle* filter = oidn.new_filter(device, "RT");
        set_image(filter, name, buffer);
        set_image(filter, "output", buffer);
        execute(filter, quality);
    }
};

Denoiser::Denoiser(bool on_gpu) : state_(std::make_unique<State>(on_gpu)) {}
Denoiser::~Denoiser() = default;
Denoiser::Denoiser(Denoiser&&) noexcept = default;
Denoiser& Denoiser::operator=(Denoiser&&) noexcept = default;

std::vector<float> Denoiser::run(const NoisyImage& image, DenoiseQuality quality) {
    State& s = *state_;
    s.resize(image.width, image.height);
    constexpr float kMost = 1e15f;
    s.write(s.color, image.radiance, 0, kMost);
    const bool has_albedo = image.albedo.size() == image.radiance.size();
    const bool has_normal = has_albedo && image.normal.size() == image.radiance.size();
    if (has_albedo) s.write(s.albedo, image.albedo, 0, 1);
    if (has_normal) s.write(s.normal, image.normal, -1, 1);
    s.check();

    const bool is_final = quality == DenoiseQuality::Final;
    if (is_final && has_albedo) s.prefilter("albedo", s.albedo, quality);
    if (is_final && has_normal) s.prefilter("normal", s.normal, quality);
    OidnFilterHandle* filter = s.oidn.new_filter(s.device, "RT");
    s.set_image(filter, "color", s.color);
    if (has_albedo) s.set_image(filter, "albedo", s.albedo);
    if (has_normal) s.set_image(filter, "normal", s.normal);
    s.set_image(filter, "output", s.output);
    s.oidn.set_bool(filter, "hdr", true);
    s.oidn.set_bool(filter, "cleanAux", is_final && has_albedo);
    s.execute(filter, quality);

    std::vector<float> clean(image.radiance.size());
    s.oidn.read_buffer(s.output, 0, s.bytes(), clean.data());
    s.check();
    return clean;
}

std::string Denoiser::name() const {
    return fmt::format("Open Image Denoise {}.{}.{} on the {}",
                       state_->oidn.device_int(state_->device, "versionMajor"),
                       state_->oidn.device_int(state_->device, "versionMinor"),
                       state_->oidn.device_int(state_->device, "versionPatch"),
                       state_->is_gpu ? "GPU" : "processor");
}

std::string Denoiser::why_missing() {
    std::string why;
    if (oidn_library(why)) return {};
    return fmt::format("Open Image Denoise: {} ({})", why, kRemedy);
}

}  // namespace tp
