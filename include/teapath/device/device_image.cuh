// A picture in device memory that two threads share: one fills it, the other shows it. Events order
// their work on the device; no thread waits.
#pragma once

#include <teapath/device/cuda_buffer.cuh>
#include <teapath/device/cuda_stream.cuh>
#include <teapath/kernel/records.h>

namespace tp {

struct DeviceImage {
    int device = 0;                // CUDA device number
    DeviceBuffer<Real4> radiance;  // mean per pixel, row-major, top row first
    Event filled;                  // recorded by who fills it
    Event shown;                   // recorded by who has put it on the screen
};

}  // namespace tp
