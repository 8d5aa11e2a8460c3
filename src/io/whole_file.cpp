#include "whole_file.h"

#include <teapath/core/error.h>

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

namespace tp {
namespace fs = std::filesystem;

void write_whole_file(const fs::path& file, std::string_view bytes) {
    // A device or pipe is written in place; everything else by way of a temporary file.
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::is_directory(status))
        throw Error(ErrorKind::Output, "this is a folder", file.string(), "name a file in it");
    const bool in_place = fs::exists(status) && !fs::is_regular_file(status);
    const fs::path target =
        in_place ? file : fs::path(file.string() + fmt::format(".{}.tmp", ::getpid()));
    std::FILE* stream = std::fopen(target.c_str(), "wb");
    if (!stream)
        throw Error(ErrorKind::Output,
                    fmt::format("the file cannot be written: {}", std::strerror(errno)),
                    file.string(), "check that the folder exists and may be written to");
    errno = 0;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), stream) == bytes.size();
    const int write_error = errno;
    const bool closed = std::fclose(stream) == 0;
    const int close_error = errno;
    if (written && closed) {
        if (in_place) return;
        fs::rename(target, file, error);
        if (!error) return;
    }
    const int code = !written ? write_error : !closed ? close_error : error.value();
    if (!in_place) fs::remove(target, error);
    throw Error(
        ErrorKind::Output,
        fmt::format("the file could not be written whole: {}", std::strerror(code)), file.string(),
        code == ENOSPC ? "free some space, or write to another disk" : "write to another folder");
}

std::string read_whole_file(const fs::path& file, const char* kind, uintmax_t limit) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status))
        throw Error(ErrorKind::Input, "there is no such file", file.string(), "check the path");
    if (fs::is_directory(status))
        throw Error(ErrorKind::Input, "this is a folder", file.string(),
                    fmt::format("name {}", kind));
    if (fs::is_regular_file(status) && fs::file_size(file, error) > limit)
        throw Error(ErrorKind::Input, fmt::format("the file is larger than {} MiB", limit >> 20),
                    file.string(), fmt::format("name {}", kind));
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        throw Error(ErrorKind::Input,
                    fmt::format("the file cannot be opened: {}", std::strerror(errno)),
                    file.string(), "check its permissions");
    std::ostringstream text;
    text << stream.rdbuf();
    if (stream.bad())
        throw Error(ErrorKind::Input, "the file cannot be read", file.string(), "check the disk");
    return std::move(text).str();
}

}  // namespace tp
