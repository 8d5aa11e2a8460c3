// The CUDA devices of this machine. Callable in every build.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tp {

struct DeviceInfo {
    int index = 0;
    std::string name;
    int compute_major = 0;
    int compute_minor = 0;
    int multiprocessors = 0;
    size_t memory_bytes = 0;
    std::string uuid;
};

struct DeviceList {
    std::vector<DeviceInfo> devices;
    std::string status;  // why there is none, for people; empty if all is well
};

DeviceList cuda_devices();

}  // namespace tp
