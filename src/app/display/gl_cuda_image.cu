#include "gl_cuda_image.h"

#include <teapath/core/error.h>
#include <teapath/device/device_image.cuh>
#include <teapath/kernel/post.h>

#include <GL/gl.h>
#include <cuda_gl_interop.h>

#include <algorithm>
#include <array>

namespace tp {
namespace {

constexpr int kThreads = 256;

// Exposure, tone curve and 8 bits for every pixel, into linear memory or onto a surface.
__global__ void linear_kernel(const Real4* radiance, uint32_t pixels, DisplaySettings display,
                              Rgba8* rgba) {
    const uint32_t i = blockIdx.x * kThreads + threadIdx.x;
    if (i >= pixels) return;
    const Real4 r = radiance[i];
    rgba[i] = opaque(display_color({r.x, r.y, r.z}, display));
}

__global__ void surface_kernel(const Real4* radiance, uint32_t width, uint32_t pixels,
                               DisplaySettings display, cudaSurfaceObject_t surface) {
    const uint32_t i = blockIdx.x * kThreads + threadIdx.x;
    if (i >= pixels) return;
    const Real4 r = radiance[i];
    const Rgba8 c = opaque(display_color({r.x, r.y, r.z}, display));
    surf2Dwrite(make_uchar4(c.r, c.g, c.b, c.a), surface,
                static_cast<int>(i % width * sizeof(uchar4)), static_cast<int>(i / width));
}

unsigned groups(uint32_t pixels) {
    return (pixels + kThreads - 1) / kThreads;
}

uint32_t pixels_of(const DisplayImage& image) {
    return static_cast<uint32_t>(image.width) * static_cast<uint32_t>(image.height);
}

// Page-locked host memory, move-free.
class PinnedMemory {
public:
    ~PinnedMemory() { cudaFreeHost(data_); }
    uint8_t* resize(size_t bytes) {
        if (bytes > capacity_) {
            check(cudaFreeHost(std::exchange(data_, nullptr)));
            capacity_ = 0;
            check(cudaMallocHost(&data_, bytes));
            capacity_ = bytes;
        }
        size_ = bytes;
        return static_cast<uint8_t*>(data_);
    }
    std::span<const uint8_t> bytes() const { return {static_cast<const uint8_t*>(data_), size_}; }

private:
    void* data_ = nullptr;
    size_t size_ = 0, capacity_ = 0;
};

// A resource of GL that CUDA may use while this lives.
class Mapping {
public:
    Mapping(cudaGraphicsResource_t resource, const Stream& stream)
        : resource_(resource), stream_(stream) {
        check(cudaGraphicsMapResources(1, &resource_, stream_.get()));
    }
    ~Mapping() { cudaGraphicsUnmapResources(1, &resource_, stream_.get()); }
    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;

    cudaArray_t array() const {
        cudaArray_t array = nullptr;
        check(cudaGraphicsSubResourceGetMappedArray(&array, resource_, 0, 0));
        return array;
    }
    Rgba8* pointer() const {
        void* pointer = nullptr;
        size_t bytes = 0;
        check(cudaGraphicsResourceGetMappedPointer(&pointer, &bytes, resource_));
        return static_cast<Rgba8*>(pointer);
    }

private:
    cudaGraphicsResource_t resource_;
    const Stream& stream_;
};

}  // namespace

class GlCudaImage::Registration {
public:
    explicit Registration(DisplayWay used_for) : way(used_for) {}
    ~Registration() {
        if (resource) cudaGraphicsUnregisterResource(resource);
    }
    Registration(const Registration&) = delete;
    Registration& operator=(const Registration&) = delete;

    DisplayWay way;
    cudaGraphicsResource_t resource = nullptr;
};

struct GlCudaImage::State {
    // The device is made current before anything is made on it.
    explicit State(int index) : device((check(cudaSetDevice(index)), index)) {}

    int device;
    Stream stream{StreamPriority::High};
    DeviceBuffer<Rgba8> linear;
    PinnedMemory pinned;
    Event start, end;
    bool is_timed = false;     // start and end have been recorded
    bool is_download = false;  // the last work is a download
    double last_ms = 0;

    // Runs `work` on the stream once the picture is filled, and lets its renderer know.
    template <class Work>
    void run(DeviceImage& image, Work&& work) {
        check(cudaSetDevice(device));
        image.filled.hold(stream);
        start.record(stream);
        work();
        end.record(stream);
        image.shown.record(stream);
        is_timed = true;
    }

    Rgba8* write_linear(const DisplayImage& image, const DisplaySettings& display, Rgba8* target) {
        const uint32_t pixels = pixels_of(image);
        linear_kernel<<<groups(pixels), kThreads, 0, stream.get()>>>(image.device->radiance.data(),
                                                                     pixels, display, target);
        check(cudaGetLastError());
        return target;
    }
};

GlCudaImage::GlCudaImage(int device) : state_(std::make_unique<State>(device)) {}
GlCudaImage::~GlCudaImage() = default;

int GlCudaImage::device() const {
    return state_->device;
}

bool GlCudaImage::shares_device() const {
    std::array<int, 16> devices{};
    unsigned count = 0;
    if (cudaGLGetDevices(&count, devices.data(), static_cast<unsigned>(devices.size()),
                         cudaGLDeviceListAll) != cudaSuccess) {
        cudaGetLastError();  // a software GL is no error
        return false;
    }
    return std::find(devices.begin(), devices.begin() + count, state_->device) !=
           devices.begin() + count;
}

std::shared_ptr<GlCudaImage::Registration> GlCudaImage::register_texture(unsigned texture,
                                                                         DisplayWay way) {
    auto registration = std::make_shared<Registration>(way);
    check(cudaGraphicsGLRegisterImage(&registration->resource, texture, GL_TEXTURE_2D,
                                      way == DisplayWay::Image
                                          ? cudaGraphicsRegisterFlagsSurfaceLoadStore
                                          : cudaGraphicsRegisterFlagsWriteDiscard));
    return registration;
}

std::shared_ptr<GlCudaImage::Registration> GlCudaImage::register_buffer(unsigned buffer) {
    auto registration = std::make_shared<Registration>(DisplayWay::Buffer);
    check(cudaGraphicsGLRegisterBuffer(&registration->resource, buffer,
                                       cudaGraphicsRegisterFlagsWriteDiscard));
    return registration;
}

void GlCudaImage::show(const DisplayImage& image, const DisplaySettings& display,
                       Registration& target) {
    State& s = *state_;
    s.is_download = false;
    s.run(*image.device, [&] {
        const Mapping mapping(target.resource, s.stream);
        if (target.way == DisplayWay::Buffer) {
            s.write_linear(image, display, mapping.pointer());
        } else if (target.way == DisplayWay::ArrayCopy) {
            s.linear.resize(pixels_of(image), 64);
            const size_t row = static_cast<size_t>(image.width) * sizeof(Rgba8);
            check(cudaMemcpy2DToArrayAsync(
                mapping.array(), 0, 0, s.write_linear(image, display, s.linear.data()), row, row,
                static_cast<size_t>(image.height), cudaMemcpyDeviceToDevice, s.stream.get()));
        } else {
            cudaResourceDesc description{};
            description.resType = cudaResourceTypeArray;
            description.res.array.array = mapping.array();
            cudaSurfaceObject_t surface = 0;
            check(cudaCreateSurfaceObject(&surface, &description));
            const uint32_t pixels = pixels_of(image);
            surface_kernel<<<groups(pixels), kThreads, 0, s.stream.get()>>>(
                image.device->radiance.data(), static_cast<uint32_t>(image.width), pixels, display,
                surface);
            const cudaError_t launched = cudaGetLastError();
            cudaDestroySurfaceObject(surface);
            check(launched);
        }
    });
}

void GlCudaImage::start_download(const DisplayImage& image, const DisplaySettings& display) {
    State& s = *state_;
    const size_t bytes = pixels_of(image) * sizeof(Rgba8);
    s.linear.resize(pixels_of(image), 64);
    uint8_t* target = s.pinned.resize(bytes);
    s.is_download = true;
    s.run(*image.device, [&] {
        check(cudaMemcpyAsync(target, s.write_linear(image, display, s.linear.data()), bytes,
                              cudaMemcpyDeviceToHost, s.stream.get()));
    });
}

std::span<const uint8_t> GlCudaImage::finished_download() {
    if (!state_->is_download || !state_->end.is_reached()) return {};
    return state_->pinned.bytes();
}

double GlCudaImage::last_ms() {
    State& s = *state_;
    if (s.is_timed && s.end.is_reached())
        s.last_ms = static_cast<double>(s.end.milliseconds_since(s.start));
    return s.last_ms;
}

int device_of(const DisplayImage& image) {
    return image.device ? image.device->device : -1;
}

}  // namespace tp
