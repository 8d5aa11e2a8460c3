// libFuzzer's entry for mesh files (CONTRIBUTING.md says how it is built and run).
#include "fuzz_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (!tp::test::fuzz_mesh(data, size)) __builtin_trap();
    return 0;
}
