#include <teapath/device/cuda_check.cuh>
#include <teapath/device/devices.h>

#include <cstdio>

namespace tp {

DeviceList cuda_devices() {
    DeviceList list;
    int count = 0;
    if (const cudaError_t code = cudaGetDeviceCount(&count); code != cudaSuccess) {
        list.status = cudaGetErrorString(code);
        return list;
    }
    for (int i = 0; i < count; ++i) {
        cudaDeviceProp p;
        check(cudaGetDeviceProperties(&p, i));
        std::string uuid;
        for (const char byte : p.uuid.bytes) {
            char hex[3];
            std::snprintf(hex, sizeof hex, "%02x",
                          static_cast<unsigned>(static_cast<unsigned char>(byte)));
            uuid += hex;
        }
        list.devices.push_back(
            {i, p.name, p.major, p.minor, p.multiProcessorCount, p.totalGlobalMem, uuid});
    }
    if (count == 0) list.status = "no CUDA device";
    return list;
}

}  // namespace tp
