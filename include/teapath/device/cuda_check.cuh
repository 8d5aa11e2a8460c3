// The one place that turns CUDA's codes into Error.
#pragma once

#include <cuda_runtime_api.h>

#include <source_location>

namespace tp {

/// Throws Error(Device) unless `code` is cudaSuccess: what CUDA says, the place of the call, and a
/// remedy for full memory and a lost device. TEAPATH_CUDA_FAIL=N:CODE in the environment makes the
/// N-th call of the process fail with that code (2: out of memory, 719: device lost), for tests.
void check(cudaError_t code, std::source_location where = std::source_location::current());

}  // namespace tp
