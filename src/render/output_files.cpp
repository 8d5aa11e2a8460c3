#include <teapath/core/error.h>
#include <teapath/io/image_file.h>
#include <teapath/render/output_files.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>

namespace tp {
namespace {

namespace fs = std::filesystem;

std::string lower_extension(const fs::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

void check_format(const fs::path& file) {
    constexpr const char* kFormats =
        "end its name in .png, .jpg, .bmp, .tga, .ppm, .hdr, .pfm or .exr";
    if (file == "-")
        throw Error(ErrorKind::Usage, "a picture cannot go to standard output", "-o -",
                    "name a file, as in -o image.png");
    if (file.empty())
        throw Error(ErrorKind::Usage, "the name of a file is missing", "-o", kFormats);
    if (can_write_image(file)) return;
    const std::string extension = file.extension().string();
    throw Error(ErrorKind::Usage,
                extension.empty()
                    ? "a name without extension does not say which format to write"
                    : fmt::format("'{}' is not a format that can be written", extension),
                file.string(), kFormats);
}

[[noreturn]] void throw_unwritable(const fs::path& file, const std::string& why,
                                   const std::string& remedy) {
    throw Error(ErrorKind::Output, "cannot write: " + why, file.string(), remedy);
}

void check_folder(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    std::error_code error;
    const fs::file_status status = fs::status(folder, error);
    if (status.type() == fs::file_type::not_found)
        throw_unwritable(file, fmt::format("there is no folder {}", folder.string()),
                         fmt::format("make it first: mkdir -p {}", folder.string()));
    if (error) throw_unwritable(file, error.message(), "name a file in another folder");
    if (!fs::is_directory(status))
        throw_unwritable(file, fmt::format("{} is not a folder", folder.string()),
                         "name a file in a folder");
    // Only making a file there shows that one can be made: the folder may be on a read-only disk,
    // a remote one with rules of its own, or in /proc. The name is as long as the final one's will
    // be on the way.
    const std::string probe = fmt::format("{}.{}.tmp", file.string(), getpid());
    const int made = open(probe.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (made < 0 && errno != EEXIST)
        throw_unwritable(file, std::strerror(errno),
                         "name a file in a folder that you may write to");
    if (made < 0) return;
    close(made);
    unlink(probe.c_str());
}

// A new file, or a plain one that may be replaced.
void check_target(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) return;
    if (error) throw_unwritable(file, error.message(), "choose another name");
    if (fs::is_directory(status))
        throw_unwritable(file, "it is a folder", "add the name of a file");
    if (!fs::is_regular_file(status))
        throw_unwritable(file, "it is not a plain file", "choose another name");
    if (access(file.c_str(), W_OK) != 0)
        throw_unwritable(file, std::strerror(errno), "allow writing to it, or choose another name");
}

void check_not_twice(const std::vector<fs::path>& files) {
    for (size_t i = 0; i < files.size(); ++i) {
        for (size_t j = 0; j < i; ++j) {
            std::error_code error;
            const bool same = fs::weakly_canonical(fs::absolute(files[i])) ==
                                  fs::weakly_canonical(fs::absolute(files[j])) ||
                              fs::equivalent(files[i], files[j], error);
            if (same)
                throw Error(ErrorKind::Usage, "the same file is named twice", files[i].string(),
                            "give each -o its own file");
        }
    }
}

}  // namespace

void check_outputs(const std::vector<fs::path>& files) {
    if (files.empty())
        throw Error(ErrorKind::Usage, "no file to write is named", "",
                    "add -o image.png, or several of them");
    for (const fs::path& file : files) {
        check_format(file);
        check_target(file);
        check_folder(file);
    }
    check_not_twice(files);
}

FileContent content_of(const fs::path& file) {
    const std::string extension = lower_extension(file);
    if (extension == ".exr") return FileContent::Layers;
    if (extension == ".hdr" || extension == ".pfm") return FileContent::Radiance;
    return FileContent::Display;
}

bool any_has(const std::vector<fs::path>& files, FileContent content) {
    return std::any_of(files.begin(), files.end(),
                       [&](const fs::path& file) { return content_of(file) == content; });
}

}  // namespace tp
