// A picture in the memory of a CUDA device, put into a GL texture or buffer through the display
// pass. With the .cu file the only place where CUDA and GL meet; builds without CUDA have a
// stand-in.
#pragma once

#include "display_way.h"

#include <teapath/kernel/settings.h>
#include <teapath/render/display_image.h>

#include <cstdint>
#include <memory>
#include <span>

namespace tp {

class GlCudaImage {
public:
    /// For pictures of this CUDA device. Throws Error(Device).
    explicit GlCudaImage(int device);
    ~GlCudaImage();

    /// True if this thread's GL context draws on the device, so that nothing has to cross the host.
    bool shares_device() const;
    int device() const;

    /// A texture (RGBA8) or buffer of GL as CUDA sees it; ends before the GL object does.
    class Registration;
    std::shared_ptr<Registration> register_texture(unsigned texture, DisplayWay way);
    std::shared_ptr<Registration> register_buffer(unsigned buffer);

    /// Puts the picture into what was registered; it has the picture's size. Does not wait for the
    /// device. Throws Error(Device).
    void show(const DisplayImage& image, const DisplaySettings& display, Registration& target);

    /// Starts a copy of the picture to page-locked host memory. Throws Error(Device).
    void start_download(const DisplayImage& image, const DisplaySettings& display);
    /// The RGBA bytes of the copy, once it has ended; empty before. Valid until the next start.
    std::span<const uint8_t> finished_download();

    /// Milliseconds that the device took for the last picture that has ended; does not wait.
    double last_ms();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The CUDA device that the picture lies on; -1 for one from the host.
int device_of(const DisplayImage& image);

}  // namespace tp
