#include "version.h"

#include <fmt/format.h>

// From the build: TEAPATH_VERSION, TEAPATH_BUILD_TYPE, TEAPATH_BUILD_HAS_CUDA.

namespace tp {
namespace {

std::string compiler() {
#if defined(__clang__)
    return fmt::format("clang {}.{}", __clang_major__, __clang_minor__);
#else
    return fmt::format("g++ {}.{}", __GNUC__, __GNUC_MINOR__);
#endif
}

}  // namespace

std::string version() {
    return TEAPATH_VERSION;
}

std::string version_line() {
    return fmt::format("Teapath {} ({}; {}, {})", version(),
                       built_with_cuda() ? "CUDA and host" : "host only", compiler(),
                       TEAPATH_BUILD_TYPE);
}

bool built_with_cuda() {
    return TEAPATH_BUILD_HAS_CUDA != 0;
}

}  // namespace tp
