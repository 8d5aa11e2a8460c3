// A CUDA stream, move-only; its work does not wait for the legacy default stream.
#pragma once

#include <teapath/device/cuda_check.cuh>

#include <utility>

namespace tp {

/// High: its kernels start before those of other streams that wait for a multiprocessor.
enum class StreamPriority { Normal, High };

class Stream {
public:
    explicit Stream(StreamPriority priority = StreamPriority::Normal) {
        int lowest = 0, highest = 0;
        check(cudaDeviceGetStreamPriorityRange(&lowest, &highest));
        check(cudaStreamCreateWithPriority(&stream_, cudaStreamNonBlocking,
                                           priority == StreamPriority::High ? highest : lowest));
    }
    ~Stream() {
        if (stream_) cudaStreamDestroy(stream_);
    }
    Stream(Stream&& other) noexcept : stream_(std::exchange(other.stream_, nullptr)) {}
    Stream& operator=(Stream&& other) noexcept {
        std::swap(stream_, other.stream_);
        return *this;
    }

    cudaStream_t get() const { return stream_; }
    void wait() const { check(cudaStreamSynchronize(stream_)); }

private:
    cudaStream_t stream_ = nullptr;
};

/// A CUDA event, move-only.
class Event {
public:
    Event() { check(cudaEventCreate(&event_)); }
    ~Event() {
        if (event_) cudaEventDestroy(event_);
    }
    Event(Event&& other) noexcept : event_(std::exchange(other.event_, nullptr)) {}
    Event& operator=(Event&& other) noexcept {
        std::swap(event_, other.event_);
        return *this;
    }

    void record(const Stream& stream) { check(cudaEventRecord(event_, stream.get())); }
    void wait() const { check(cudaEventSynchronize(event_)); }
    /// Later work of `stream` waits until this event was reached; the caller does not.
    void hold(const Stream& stream) const { check(cudaStreamWaitEvent(stream.get(), event_, 0)); }
    /// True once it was reached, or never recorded.
    bool is_reached() const {
        const cudaError_t state = cudaEventQuery(event_);
        if (state != cudaErrorNotReady) check(state);
        return state == cudaSuccess;
    }

    /// Milliseconds from `start` to this event; both have been reached.
    float milliseconds_since(const Event& start) const {
        float ms = 0;
        check(cudaEventElapsedTime(&ms, start.event_, event_));
        return ms;
    }

private:
    cudaEvent_t event_ = nullptr;
};

}  // namespace tp
