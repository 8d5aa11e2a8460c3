// libFuzzer's entry for glTF files (CONTRIBUTING.md says how it is built and run).
#include "fuzz_model.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (!tp::test::fuzz_gltf(data, size)) __builtin_trap();
    return 0;
}
