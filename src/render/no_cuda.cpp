// Stands in for the CUDA backend in builds without it.
#include <teapath/core/error.h>
#include <teapath/device/devices.h>
#include <teapath/render/backend.h>
#include <teapath/render/kernel_report.h>

namespace tp {

std::unique_ptr<Backend> make_cuda_backend(int, double) {
    throw Error(ErrorKind::Device, "this build has no CUDA backend", "",
                "build with the CUDA Toolkit, or render with --backend host");
}

std::vector<KernelReport> kernel_reports() {
    return {};
}

DeviceList cuda_devices() {
    return {{}, "this build has no CUDA backend"};
}

}  // namespace tp
