// The GL texture that shows the render, and how pictures get into it; RAII. A picture of the host
// is copied; one of a CUDA device goes over on the card, or through page-locked memory where CUDA
// and GL do not share one.
#pragma once

#include "gl_cuda_image.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tp {

class DisplayTexture {
public:
    /// Textures that are kept at most.
    static constexpr size_t kSlots = 4;

    DisplayTexture();
    ~DisplayTexture();
    DisplayTexture(const DisplayTexture&) = delete;
    DisplayTexture& operator=(const DisplayTexture&) = delete;

    /// Takes a newer picture; it shows after the next update.
    void set_image(DisplayImage image);
    /// Puts the picture on the screen's side if it or `display` is new. Called once a frame; does
    /// not wait for a device. Throws Error(Device) where the device is lost; the old picture stays.
    void update(const DisplaySettings& display);

    /// How pictures of a device get here; Auto picks.
    void set_way(DisplayWay way);
    /// The way that the last picture took.
    DisplayWay way() const { return used_way_; }
    /// Milliseconds of the last picture: on the device, or of the copy from the host.
    double show_ms();

    /// What is shown, read back: RGB bytes, top row first.
    std::vector<uint8_t> pixels() const;

    uint64_t id() const;
    int width() const;
    int height() const;
    int64_t samples() const { return shown_samples_; }  // per pixel, of what is shown
    /// Gives up everything that belongs to a CUDA device, as before that device's renderer ends.
    void release_device();

private:
    struct Slot;
    Slot& slot_for(int width, int height);
    void show_host_image();
    void show_device_image(const DisplaySettings& display);
    void finish_download();
    DisplayWay choose_way() const;

    // A texture for each of the last few sizes: resolution changes while the camera moves.
    std::vector<std::unique_ptr<Slot>> slots_;  // the one in use first
    std::unique_ptr<GlCudaImage> interop_;
    DisplayImage image_;  // the newest; its pixels are gone once they are on the screen's side
    DisplaySettings display_;
    bool is_new_ = false;
    DisplayImage download_;  // what is on its way through the host
    DisplayWay way_ = DisplayWay::Auto, used_way_ = DisplayWay::Upload;
    bool shares_device_ = false;
    int64_t shown_samples_ = 0;
    double copy_ms_ = 0;
};

}  // namespace tp
