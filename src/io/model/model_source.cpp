#include "model_source.h"

#include "../whole_file.h"

#include <teapath/core/error.h>
#include <teapath/io/image_file.h>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace tp {
namespace fs = std::filesystem;

namespace {

constexpr uintmax_t kMaxFileBytes = uintmax_t{1} << 36;

bool starts_with_drive(std::string_view name) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    return name.size() >= 2 && is_letter(name[0]) && name[1] == ':';
}

}  // namespace

fs::path path_beside(const ModelSource& source, std::string_view name, const std::string& where) {
    if (name.empty() || name.find('\0') != std::string_view::npos)
        throw Error(ErrorKind::Input, "the name of a file is missing", where,
                    "export the model again");
    if (name.find("://") != std::string_view::npos)
        throw Error(ErrorKind::Input, fmt::format("{} is a web address", name), where,
                    "download the file and put it beside the model");
    std::string text(name);
    std::replace(text.begin(), text.end(), '\\', '/');
    const fs::path relative = fs::path(text).lexically_normal();
    const bool climbs = !relative.empty() && *relative.begin() == "..";
    if (!source.allow_outside && (relative.is_absolute() || climbs || starts_with_drive(text)))
        throw Error(ErrorKind::Input, fmt::format("{} leads outside the folder of the model", name),
                    where, "put the file beside the model and name it relative to that folder");
    return source.folder / relative;
}

std::string read_beside(const ModelSource& source, std::string_view name, const char* kind,
                        const std::string& where) {
    const fs::path path = path_beside(source, name, where);
    if (!source.has_files)
        throw Error(ErrorKind::Input, "the file is not there", path.string(),
                    "put it beside the model");
    return read_whole_file(path, kind, kMaxFileBytes);
}

uint64_t memory_for(const ModelSource& source) {
    if (source.memory) return source.memory;
    const auto pages = static_cast<uint64_t>(std::max(sysconf(_SC_PHYS_PAGES), 0L));
    const auto page = static_cast<uint64_t>(std::max(sysconf(_SC_PAGESIZE), 0L));
    return std::max(pages * page / 4 * 3, uint64_t{1} << 30);
}

void check_memory(const ModelSource& source, double bytes) {
    if (bytes <= static_cast<double>(memory_for(source))) return;
    constexpr double kMebi = 1 << 20;
    throw Error(ErrorKind::Input,
                fmt::format("the model needs {:.0f} MiB, and {:.0f} can be had", bytes / kMebi,
                            static_cast<double>(memory_for(source)) / kMebi),
                source.name, "take a smaller model, or a machine with more memory");
}

void ImageBudget::take(std::string_view bytes) {
    const uint64_t wanted = bytes_of_image(bytes);
    check_memory(source_, static_cast<double>(taken_.fetch_add(wanted) + wanted));
}

}  // namespace tp
