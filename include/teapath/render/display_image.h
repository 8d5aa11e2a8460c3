// A finished picture on its way to the window. It is handed from the thread that traces to the one
// that draws by sharing, so that neither waits for the other.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace tp {

/// A picture in device memory, as linear radiance; device_image.cuh has what is inside.
struct DeviceImage;

struct DisplayImage {
    int width = 0;
    int height = 0;
    int64_t samples = 0;  // per pixel
    /// From the host: RGBA bytes after exposure and tone curve, row-major, top row first.
    std::vector<uint8_t> rgba;
    /// From a CUDA device: radiance, which who shows it puts through the display pass. Null on the
    /// host.
    std::shared_ptr<DeviceImage> device;

    bool empty() const { return rgba.empty() && !device; }
};

}  // namespace tp
