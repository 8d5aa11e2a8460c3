// libFuzzer's entry for OBJ files with materials (CONTRIBUTING.md says how it is built and run).
#include "fuzz_model.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (!tp::test::fuzz_obj_model(data, size)) __builtin_trap();
    return 0;
}
