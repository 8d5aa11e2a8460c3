#include "clipboard.h"

#include <teapath/core/error.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>

extern char** environ;

namespace tp {
namespace {

bool is_set(const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
}

bool is_in_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((folder + "/" + program).c_str(), X_OK) == 0) return true;
    return false;
}

}  // namespace

std::vector<std::string> clipboard_command() {
    if (is_set("WAYLAND_DISPLAY") && is_in_path("wl-copy")) return {"wl-copy", "-t", "image/png"};
    if (is_set("DISPLAY") && is_in_path("xclip"))
        return {"xclip", "-selection", "clipboard", "-t", "image/png"};
    return {};
}

std::string why_no_clipboard() {
    if (!clipboard_command().empty()) return "";
    return is_set("WAYLAND_DISPLAY") ? "install wl-clipboard (wl-copy) to copy images"
                                     : "install xclip to copy images";
}

void copy_png(const std::filesystem::path& file) {
    const std::vector<std::string> command = clipboard_command();
    if (command.empty()) throw Error(ErrorKind::Output, why_no_clipboard());
    std::vector<char*> arguments;
    for (const std::string& word : command)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);

    // The tool leaves a process behind that holds the image; it must not hold our streams.
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, file.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t pid = 0;
    const int error =
        posix_spawnp(&pid, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    int status = 0;
    while (error == 0 && waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    if (error != 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw Error(ErrorKind::Output,
                    fmt::format("{} did not take the image{}", command[0],
                                error != 0 ? fmt::format(": {}", std::strerror(error)) : ""));
}

}  // namespace tp
