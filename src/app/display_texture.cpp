#include "display_texture.h"

#include <glad/gl.h>

namespace tp {

DisplayTexture::~DisplayTexture() {
    if (texture_) glDeleteTextures(1, &texture_);
}

void DisplayTexture::upload(const std::vector<uint8_t>& rgb, int width, int height) {
    if (width != width_ || height != height_) {
        if (texture_) glDeleteTextures(1, &texture_);
        glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
        glTextureStorage2D(texture_, 1, GL_RGBA8, width, height);
        glTextureParameteri(texture_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTextureParameteri(texture_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        width_ = width;
        height_ = height;
        set_smooth(true);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture_, 0, 0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
}

std::vector<uint8_t> DisplayTexture::pixels() const {
    std::vector<uint8_t> rgb(3 * static_cast<std::size_t>(width_) *
                             static_cast<std::size_t>(height_));
    if (texture_ == 0) return rgb;
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture_, 0, GL_RGB, GL_UNSIGNED_BYTE, static_cast<GLsizei>(rgb.size()),
                      rgb.data());
    return rgb;
}

void DisplayTexture::set_smooth(bool smooth) {
    const GLint filter = smooth ? GL_LINEAR : GL_NEAREST;
    glTextureParameteri(texture_, GL_TEXTURE_MIN_FILTER, filter);
    glTextureParameteri(texture_, GL_TEXTURE_MAG_FILTER, filter);
}

}  // namespace tp
