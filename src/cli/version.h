// What this build is.
#pragma once

#include <string>

namespace tp {

/// For metadata: "0.1.0".
std::string version();

/// For people: "Teapath 0.1.0 (CUDA and host; g++ 12.2, Release)".
std::string version_line();

/// True if the CUDA backend was built.
bool built_with_cuda();

}  // namespace tp
