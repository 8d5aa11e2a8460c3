// What the fuzzer of mesh files does with an input: the first byte chooses the format, the rest is
// the file. Whatever it is, it becomes a mesh without problems or an Error.
#pragma once

#include "io/mesh/mesh_readers.h"

#include <teapath/core/error.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tp::test {

/// True if the input was taken or refused as it should be.
inline bool fuzz_mesh(const uint8_t* data, size_t size) {
    if (size == 0) return true;
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        switch (data[0] % 3) {
            case 0: return problem_of(read_ply(bytes, "fuzz")).empty();
            case 1: return problem_of(read_stl(bytes, "fuzz")).empty();
            default: return problem_of(read_obj(bytes, "fuzz")).empty();
        }
    } catch (const Error&) {
        return true;
    }
}

}  // namespace tp::test
