#include "display_texture.h"

#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace tp {

// A texture of one size, with the buffer that fills it in the Buffer way.
struct DisplayTexture::Slot {
    Slot(int w, int h) : width(w), height(h) {
        glCreateTextures(GL_TEXTURE_2D, 1, &texture);
        glTextureStorage2D(texture, 1, GL_RGBA8, w, h);
        glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    }
    ~Slot() {
        registration.reset();
        glDeleteTextures(1, &texture);
        if (buffer) glDeleteBuffers(1, &buffer);
    }
    Slot(const Slot&) = delete;
    Slot& operator=(const Slot&) = delete;

    // RGBA bytes from memory, or from the bound buffer where `rgba` is null.
    void fill(const void* rgba) const {
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        glTextureSubImage2D(texture, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    }
    void fill_from_buffer() const {
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
        fill(nullptr);
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    }

    // Makes the texture, or its buffer, known to CUDA for this way.
    void register_for(GlCudaImage& interop, DisplayWay way) {
        if (registration && registered_way == way) return;
        registration.reset();
        if (way == DisplayWay::Buffer) {
            if (!buffer) {
                glCreateBuffers(1, &buffer);
                glNamedBufferStorage(buffer, GLsizeiptr{4} * width * height, nullptr, 0);
            }
            registration = interop.register_buffer(buffer);
        } else {
            registration = interop.register_texture(texture, way);
        }
        registered_way = way;
    }

    int width, height;
    unsigned texture = 0, buffer = 0;
    std::shared_ptr<GlCudaImage::Registration> registration;
    DisplayWay registered_way = DisplayWay::Auto;
};

DisplayTexture::DisplayTexture() = default;

DisplayTexture::~DisplayTexture() {
    release_device();
}

void DisplayTexture::release_device() {
    for (const auto& slot : slots_)
        slot->registration.reset();
    interop_.reset();
    if (image_.device) image_ = {};
    download_ = {};
    is_new_ = false;
}

void DisplayTexture::set_image(DisplayImage image) {
    image_ = std::move(image);
    is_new_ = true;
}

void DisplayTexture::update(const DisplaySettings& display) {
    if (download_.device) finish_download();
    if (image_.empty()) return;
    // The host's pictures have been through the display pass already.
    if (!is_new_ && (!image_.device || display == display_)) return;
    if (download_.device) return;  // a later frame takes it
    if (image_.device)
        show_device_image(display);
    else
        show_host_image();
    display_ = display;
    is_new_ = false;
}

void DisplayTexture::show_host_image() {
    const auto start = std::chrono::steady_clock::now();
    slot_for(image_.width, image_.height).fill(image_.rgba.data());
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - start;
    copy_ms_ = taken.count();
    used_way_ = DisplayWay::Upload;
    shown_samples_ = image_.samples;
    image_.rgba.clear();
}

void DisplayTexture::show_device_image(const DisplaySettings& display) {
    // The picture may come from another device than the last one.
    if (!interop_ || interop_->device() != device_of(image_)) {
        for (const auto& slot : slots_)
            slot->registration.reset();
        interop_ = std::make_unique<GlCudaImage>(device_of(image_));
        shares_device_ = interop_->shares_device();
    }
    used_way_ = choose_way();
    if (used_way_ == DisplayWay::Upload) {
        interop_->start_download(image_, display);
        download_ = image_;
        return;
    }
    Slot& slot = slot_for(image_.width, image_.height);
    slot.register_for(*interop_, used_way_);
    interop_->show(image_, display, *slot.registration);
    if (used_way_ == DisplayWay::Buffer) slot.fill_from_buffer();
    shown_samples_ = image_.samples;
}

void DisplayTexture::finish_download() {
    const auto rgba = interop_->finished_download();
    if (rgba.empty()) return;
    slot_for(download_.width, download_.height).fill(rgba.data());
    shown_samples_ = download_.samples;
    download_ = {};
}

DisplayWay DisplayTexture::choose_way() const {
    if (!shares_device_) return DisplayWay::Upload;
    return way_ == DisplayWay::Auto ? DisplayWay::Image : way_;
}

void DisplayTexture::set_way(DisplayWay way) {
    if (way == way_) return;
    way_ = way;
    is_new_ = !image_.empty() && image_.device;
}

double DisplayTexture::show_ms() {
    return interop_ && image_.device ? interop_->last_ms() : copy_ms_;
}

DisplayTexture::Slot& DisplayTexture::slot_for(int width, int height) {
    auto found = std::find_if(slots_.begin(), slots_.end(), [&](const auto& slot) {
        return slot->width == width && slot->height == height;
    });
    if (found == slots_.end()) {
        if (slots_.size() >= kSlots) slots_.pop_back();
        slots_.push_back(std::make_unique<Slot>(width, height));
        found = slots_.end() - 1;
    }
    std::rotate(slots_.begin(), found, found + 1);
    return *slots_.front();
}

uint64_t DisplayTexture::id() const {
    return slots_.empty() ? 0 : slots_.front()->texture;
}
int DisplayTexture::width() const {
    return slots_.empty() ? 0 : slots_.front()->width;
}
int DisplayTexture::height() const {
    return slots_.empty() ? 0 : slots_.front()->height;
}

std::vector<uint8_t> DisplayTexture::pixels() const {
    std::vector<uint8_t> rgb(size_t{3} * static_cast<size_t>(width()) *
                             static_cast<size_t>(height()));
    if (rgb.empty()) return rgb;
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(slots_.front()->texture, 0, GL_RGB, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(rgb.size()), rgb.data());
    return rgb;
}

}  // namespace tp
