// A GL texture of one size, RGBA8, smoothed; RAII.
#pragma once

#include <cstdint>

namespace tp {

class GlTexture {
public:
    GlTexture(int width, int height);
    ~GlTexture();
    GlTexture(const GlTexture&) = delete;
    GlTexture& operator=(const GlTexture&) = delete;

    /// Bytes of every pixel, row-major, top row first; RGBA from the bound unpack buffer where
    /// `rgba` is null.
    void fill_rgba(const void* rgba) const;
    void fill_rgb(const uint8_t* rgb) const;

    unsigned id() const { return id_; }
    int width() const { return width_; }
    int height() const { return height_; }

private:
    unsigned id_ = 0;
    int width_, height_;
};

}  // namespace tp
