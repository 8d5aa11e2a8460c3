// Stands in for gl_cuda_image.cu in builds without CUDA, where no picture lies on a device.
#include "gl_cuda_image.h"

#include <teapath/core/error.h>

namespace tp {

struct GlCudaImage::State {};
class GlCudaImage::Registration {};

GlCudaImage::GlCudaImage(int) {
    throw Error(ErrorKind::Device, "this build has no CUDA", "", "render on the host");
}
GlCudaImage::~GlCudaImage() = default;
int GlCudaImage::device() const {
    return -1;
}
bool GlCudaImage::shares_device() const {
    return false;
}
std::shared_ptr<GlCudaImage::Registration> GlCudaImage::register_texture(unsigned, DisplayWay) {
    return nullptr;
}
std::shared_ptr<GlCudaImage::Registration> GlCudaImage::register_buffer(unsigned) {
    return nullptr;
}
void GlCudaImage::show(const DisplayImage&, const DisplaySettings&, Registration&) {}
void GlCudaImage::start_download(const DisplayImage&, const DisplaySettings&) {}
std::span<const uint8_t> GlCudaImage::finished_download() {
    return {};
}
double GlCudaImage::last_ms() {
    return 0;
}

int device_of(const DisplayImage&) {
    return -1;
}

}  // namespace tp
