// The program: hands over to the window or the command line, and is the last place that catches
// errors.
#include "window_command.h"

#include <teapath/cli/program.h>
#include <teapath/core/error.h>

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

namespace {

constexpr int kInternalError = 1;
constexpr int kOutOfMemory = 4;

// With a closed standard stream (`2>&-`) the next file opened would take its number, and messages
// would end up in a picture.
void open_standard_streams() {
    for (int fd = 0; fd <= 2;) {
        const int opened = open("/dev/null", O_RDWR);
        if (opened < 0) return;
        if (opened > 2) {
            close(opened);
            return;
        }
        fd = opened + 1;
    }
}

void print_error(const char* text) {
    std::fputs("error: ", stderr);
    std::fputs(text, stderr);
    std::fputc('\n', stderr);
}

}  // namespace

int main(int argc, char** argv) {
    open_standard_streams();
    // A shell's limit on the size of files is a failed write, not the end.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        if (const auto code = tp::run_window_command(argc, argv)) return *code;
        return tp::run_command_line(argc, argv);
    } catch (const tp::Error& error) {
        print_error(error.what());
        return error.exit_code();
    } catch (const std::bad_alloc&) {
        print_error("not enough memory (make the image or the scene smaller)");
        return kOutOfMemory;
    } catch (const std::exception& error) {
        print_error(error.what());
        print_error("that was not expected: please report it with the command and the scene");
        return kInternalError;
    }
}
