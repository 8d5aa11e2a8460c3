#include "whole_file.h"

#include <teapath/core/error.h>

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

namespace tp {
namespace fs = std::filesystem;

namespace {

struct CloseFile {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
};

[[noreturn]] void fail_to_write(const fs::path& file, int code, const char* remedy) {
    throw Error(ErrorKind::Output,
                fmt::format("the file cannot be written: {}", std::strerror(code)), file.string(),
                remedy);
}

// Bytes to a stream and on to the disk, so that a rename never uncovers half a file; an errno, or
// 0.
int write_and_close(std::FILE* stream, std::string_view bytes, bool to_disk) {
    errno = 0;
    int code = 0;
    if (std::fwrite(bytes.data(), 1, bytes.size(), stream) != bytes.size() ||
        std::fflush(stream) != 0)
        code = errno ? errno : EIO;
    if (code == 0 && to_disk && ::fsync(::fileno(stream)) != 0 && errno != EINVAL) code = errno;
    if (std::fclose(stream) != 0 && code == 0) code = errno;
    return code;
}

}  // namespace

void write_whole_file(const fs::path& file, std::string_view bytes) {
    // A device or pipe is written in place; everything else by way of a temporary file beside it,
    // or beside what a link leads to.
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::is_directory(status))
        throw Error(ErrorKind::Output, "this is a folder", file.string(), "name a file in it");
    const bool exists = fs::exists(status), in_place = exists && !fs::is_regular_file(status);
    if (exists && ::access(file.c_str(), W_OK) != 0)
        fail_to_write(file, errno, "choose another name, or allow writing to the file");
    fs::path final_file = file;
    if (exists && !in_place)
        if (const fs::path real = fs::canonical(file, error); !error) final_file = real;
    const fs::path target =
        in_place ? file : fs::path(final_file.string() + fmt::format(".{}.tmp", ::getpid()));

    std::FILE* stream = std::fopen(target.c_str(), "wb");
    if (!stream) fail_to_write(file, errno, "check that the folder exists and may be written to");
    int code = write_and_close(stream, bytes, !in_place);
    if (in_place && code == 0) return;
    if (code == 0) {
        // The new file may be read and written by those who could the old one.
        if (exists) fs::permissions(target, status.permissions(), error);
        fs::rename(target, final_file, error);
        if (!error) return;
        code = error.value();
    }
    if (!in_place) fs::remove(target, error);
    throw Error(
        ErrorKind::Output,
        fmt::format("the file could not be written whole: {}", std::strerror(code)), file.string(),
        code == ENOSPC ? "free some space, or write to another disk" : "write to another folder");
}

std::string read_whole_file(const fs::path& file, const char* kind, uintmax_t limit) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found)
        throw Error(ErrorKind::Input, "there is no such file", file.string(), "check the path");
    if (fs::is_directory(status))
        throw Error(ErrorKind::Input, "this is a folder", file.string(),
                    fmt::format("name {}", kind));
    const std::unique_ptr<std::FILE, CloseFile> stream(std::fopen(file.c_str(), "rb"));
    if (!stream)
        throw Error(ErrorKind::Input,
                    fmt::format("the file cannot be opened: {}", std::strerror(errno)),
                    file.string(), "check its permissions");

    // In pieces: a pipe does not say how long it is, and some devices never end.
    std::string bytes;
    if (const uintmax_t size = fs::file_size(file, error); !error && size <= limit)
        bytes.reserve(size);
    char piece[1 << 16];
    while (const size_t count = std::fread(piece, 1, sizeof piece, stream.get())) {
        if (bytes.size() + count > limit)
            throw Error(ErrorKind::Input,
                        fmt::format("the file is larger than {} MiB", limit >> 20), file.string(),
                        fmt::format("name {}", kind));
        bytes.append(piece, count);
    }
    if (std::ferror(stream.get()))
        throw Error(ErrorKind::Input, "the file cannot be read", file.string(), "check the disk");
    return bytes;
}

}  // namespace tp
