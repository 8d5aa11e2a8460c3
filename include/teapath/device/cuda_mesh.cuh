// A mesh in device memory: its arrays in one allocation of their own.
#pragma once

#include <teapath/device/cuda_buffer.cuh>
#include <teapath/device/cuda_stream.cuh>
#include <teapath/device/mesh_arrays.h>

#include <memory>

namespace tp {

class CudaMesh {
public:
    /// Copies the arrays, and keeps them to be known by.
    CudaMesh(std::shared_ptr<const MeshArrays> arrays, const Stream& stream);

    bool holds(const MeshArrays& arrays) const { return arrays_.get() == &arrays; }
    const MeshView& view() const { return view_; }
    size_t bytes() const { return memory_.allocated_bytes(); }

private:
    std::shared_ptr<const MeshArrays> arrays_;
    DeviceBuffer<std::byte> memory_;
    MeshView view_;
};

}  // namespace tp
