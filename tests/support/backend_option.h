// Which backend the rendering tests run on: `teapath_tests --backend host|cuda`.
#pragma once

#include <string>

namespace tp::test {

/// "host" or "cuda"; set by the runner's main before any test.
inline std::string& backend_name() {
    static std::string name = "host";
    return name;
}

}  // namespace tp::test
