#include "status.h"

#include <teapath/core/error.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace tp {

void print_status(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
}

void print_result(std::string_view text) {
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!written || std::fflush(stdout) != 0)
        throw Error(ErrorKind::Output, "cannot write to standard output", "", std::strerror(errno));
}

}  // namespace tp
