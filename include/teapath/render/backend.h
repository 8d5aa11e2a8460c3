// Where paths are traced: the host's cores or a CUDA device, behind one interface. A backend knows
// flat arrays, no scenes and no window. The Session drives it from one thread.
#pragma once

#include <teapath/device/scene_arrays.h>
#include <teapath/kernel/settings.h>
#include <teapath/render/display_image.h>
#include <teapath/render/film_image.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tp {

enum class BackendKind : uint8_t { Auto, Cuda, Host };

/// Which samples of each pixel to trace: [first, first + count).
struct SampleRange {
    int64_t first = 0;
    int64_t count = 0;
};

struct RenderCounters {
    uint64_t samples = 0;          // camera samples traced since the backend was made
    uint64_t rays = 0;             // segments of paths, and queries for light
    uint64_t invalid_samples = 0;  // NaN, infinite or over kMaxRadiance, black in the film
};

struct FilmSetup {
    int width = 0;
    int height = 0;
    bool features = false;  // also alpha, albedo, normal, depth, ids

    friend bool operator==(const FilmSetup&, const FilmSetup&) = default;
};

class Backend {
public:
    virtual ~Backend() = default;

    virtual BackendKind kind() const = 0;

    /// For people: "host, 8 threads" or "NVIDIA H200".
    virtual std::string name() const = 0;

    /// Copies the parts of the arrays that `parts` names; work under way has ended before.
    virtual void upload(const SceneArrays& arrays, SceneParts parts) = 0;

    /// Makes an empty film of that size. Throws Error(Device) where memory is short.
    virtual void reset_film(const FilmSetup& setup) = 0;

    /// Traces these samples of every pixel and adds them to the film; ranges follow each other.
    /// Returns false, leaving a film that must be reset, if `cancel` became true on the way.
    virtual bool render(const SampleRange& range, const std::atomic<bool>& cancel) = 0;

    /// The film so far. Waits for the work under way.
    virtual FilmImage read_film() = 0;

    /// Albedo and normal planes of the first `samples` samples of each pixel, traced now, whatever
    /// the film holds: what guides a denoiser.
    virtual FilmImage read_guides(int64_t samples) = 0;

    /// The film through exposure and tone curve: RGB bytes, row-major, top row first.
    virtual std::vector<uint8_t> read_display(const DisplaySettings& display) = 0;

    /// The same picture for the window: RGBA bytes from the host, radiance in device memory from a
    /// device. Later work does not change it.
    virtual DisplayImage display_image(const DisplaySettings& display) = 0;

    /// Bytes that scene and film take on the device.
    virtual size_t memory_bytes() const = 0;
    virtual RenderCounters counters() const = 0;
};

/// `threads` counts the caller; 0 = all cores that the process may use.
std::unique_ptr<Backend> make_host_backend(int threads);

/// Throws Error(Device) where this build, the driver or the device is missing. `launch_seconds` is
/// how long one launch may keep the device from others, such as the window; 0 = as long as it
/// takes.
std::unique_ptr<Backend> make_cuda_backend(int device, double launch_seconds = 0);

}  // namespace tp
