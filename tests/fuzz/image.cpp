// libFuzzer's entry for image files (CONTRIBUTING.md says how it is built and run).
#include "fuzz_model.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (!tp::test::fuzz_image(data, size)) __builtin_trap();
    return 0;
}
