// The runner's own options: which backend the rendering tests run on, `teapath_tests --backend
// host|cuda`, and whether there is time, `--long`.
#pragma once

#include <string>

namespace tp::test {

/// "host" or "cuda"; set by the runner's main before any test.
inline std::string& backend_name() {
    static std::string name = "host";
    return name;
}

/// True if tests may take minutes for more samples and rays.
inline bool& long_run() {
    static bool is_long = false;
    return is_long;
}

}  // namespace tp::test
