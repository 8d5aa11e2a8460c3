// An array in device memory, move-only. Plain device allocations, never managed memory.
#pragma once

#include <teapath/core/span.h>
#include <teapath/device/cuda_check.cuh>

#include <cstddef>
#include <utility>

namespace tp {

template <class T>
class DeviceBuffer {
public:
    DeviceBuffer() = default;
    explicit DeviceBuffer(size_t size) { resize(size); }
    ~DeviceBuffer() { cudaFree(data_); }
    DeviceBuffer(DeviceBuffer&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)),
          size_(std::exchange(other.size_, 0)),
          capacity_(std::exchange(other.capacity_, 0)) {}
    DeviceBuffer& operator=(DeviceBuffer&& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
        return *this;
    }

    /// Makes room for `size` values; the old ones are lost unless the size is the same. Freeing
    /// memory stops the device, so an allocation is kept while it is at most `slack` times too
    /// large.
    void resize(size_t size, size_t slack = 1) {
        if (size > capacity_ || size * slack < capacity_) {
            check(cudaFree(std::exchange(data_, nullptr)));
            size_ = capacity_ = 0;
            if (size > 0) {
                void* memory = nullptr;
                check(cudaMalloc(&memory, size * sizeof(T)));
                data_ = static_cast<T*>(memory);
            }
            capacity_ = size;
        }
        size_ = size;
    }

    void clear_to_zero(cudaStream_t stream) {
        if (size_ > 0) check(cudaMemsetAsync(data_, 0, bytes(), stream));
    }

    /// Copies from the host and waits.
    void upload(const T* values, size_t count, cudaStream_t stream) {
        resize(count);
        if (count == 0) return;
        check(cudaMemcpyAsync(data_, values, count * sizeof(T), cudaMemcpyHostToDevice, stream));
        check(cudaStreamSynchronize(stream));
    }

    /// Copies to the host and waits; `values` has room for size().
    void download(T* values, cudaStream_t stream) const {
        if (size_ == 0) return;
        check(cudaMemcpyAsync(values, data_, bytes(), cudaMemcpyDeviceToHost, stream));
        check(cudaStreamSynchronize(stream));
    }

    T* data() const { return data_; }
    size_t size() const { return size_; }
    size_t bytes() const { return size_ * sizeof(T); }
    size_t allocated_bytes() const { return capacity_ * sizeof(T); }

private:
    T* data_ = nullptr;
    size_t size_ = 0;
    size_t capacity_ = 0;
};

}  // namespace tp
