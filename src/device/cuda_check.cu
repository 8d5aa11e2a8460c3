#include <teapath/core/error.h>
#include <teapath/device/cuda_check.cuh>

#include <atomic>
#include <cstdlib>
#include <string>

namespace tp {
namespace {

// A failure that a test asks for.
struct InjectedFailure {
    long call = -1;
    cudaError_t code = cudaSuccess;
};

InjectedFailure read_injected_failure() {
    const char* text = std::getenv("TEAPATH_CUDA_FAIL");
    if (!text) return {};
    char* rest = nullptr;
    const long call = std::strtol(text, &rest, 10);
    if (*rest != ':') return {};
    return {call, static_cast<cudaError_t>(std::strtol(rest + 1, nullptr, 10))};
}

cudaError_t with_injected_failure(cudaError_t code) {
    static const InjectedFailure injected = read_injected_failure();
    static std::atomic<long> calls = 0;
    if (injected.call >= 0 && calls++ == injected.call) return injected.code;
    return code;
}

const char* remedy_for(cudaError_t code) {
    switch (code) {
        case cudaErrorMemoryAllocation:
            return "render a smaller picture or scene, close other programs on the GPU, or use "
                   "--backend host";
        case cudaErrorNoDevice: return "use --backend host";
        case cudaErrorInsufficientDriver:
            return "install a newer NVIDIA driver, or use --backend host";
        case cudaErrorInvalidDevice: return "`teapath info` lists the devices";
        default:
            return "the GPU's work is lost, the scene is not; try again, or use --backend host";
    }
}

std::string file_name(const char* path) {
    const std::string text = path;
    return text.substr(text.find_last_of('/') + 1);
}

}  // namespace

void check(cudaError_t code, std::source_location where) {
    code = with_injected_failure(code);
    if (code == cudaSuccess) return;
    cudaGetLastError();  // an error that is not sticky shall not show up again
    throw Error(
        ErrorKind::Device,
        std::string("CUDA: ") + cudaGetErrorString(code) + " (" + cudaGetErrorName(code) + ")",
        file_name(where.file_name()) + ":" + std::to_string(where.line()), remedy_for(code));
}

}  // namespace tp
