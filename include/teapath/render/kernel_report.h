// What the compiled path kernels take of a multiprocessor.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tp {

struct KernelReport {
    std::string name;        // which scenes it is for
    int registers = 0;       // a thread
    size_t stack_bytes = 0;  // a thread: frame and spills in local memory
    int threads = 0;         // a block
    double occupancy = 0;    // resident threads over the most, 0 to 1
};

/// One report for each variant of the path kernel on the current device; empty without CUDA.
std::vector<KernelReport> kernel_reports();

}  // namespace tp
