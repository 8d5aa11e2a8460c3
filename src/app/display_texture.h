// The GL texture that shows the render; RAII.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tp {

class DisplayTexture {
public:
    DisplayTexture() = default;
    ~DisplayTexture();
    DisplayTexture(const DisplayTexture&) = delete;
    DisplayTexture& operator=(const DisplayTexture&) = delete;

    /// Takes RGB bytes, top row first; makes the storage anew only where the size changes.
    void upload(const std::vector<uint8_t>& rgb, int width, int height);
    /// What was uploaded last, read back: RGB bytes, top row first.
    std::vector<uint8_t> pixels() const;
    /// Nearest shows pixels as they are; linear smooths a scaled picture.
    void set_smooth(bool smooth);

    uint64_t id() const { return texture_; }
    int width() const { return width_; }
    int height() const { return height_; }

private:
    unsigned texture_ = 0;
    int width_ = 0, height_ = 0;
};

}  // namespace tp
