#include "folder_list.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <ctime>
#include <tuple>

namespace tp {
namespace {

namespace fs = std::filesystem;

char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// Digits compare as numbers, letters without their case.
bool comes_before(const std::string& a, const std::string& b) {
    size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (is_digit(a[i]) && is_digit(b[j])) {
            const auto number = [](const std::string& s, size_t& at) {
                while (at < s.size() && s[at] == '0')
                    ++at;
                const size_t start = at;
                while (at < s.size() && is_digit(s[at]))
                    ++at;
                return s.substr(start, at - start);
            };
            const std::string x = number(a, i), y = number(b, j);
            if (x != y) return std::tuple(x.size(), x) < std::tuple(y.size(), y);
        } else {
            const char x = lower(a[i++]), y = lower(b[j++]);
            if (x != y) return x < y;
        }
    }
    const size_t left_a = a.size() - i, left_b = b.size() - j;
    return left_a != left_b ? left_a < left_b : a < b;
}

}  // namespace

bool FileFilter::passes(const fs::path& file) const {
    std::string text = file.filename().string();
    std::transform(text.begin(), text.end(), text.begin(), lower);
    return extensions.empty() ||
           std::any_of(extensions.begin(), extensions.end(), [&](const std::string& extension) {
               return text.size() > extension.size() && text.ends_with(extension);
           });
}

std::string FileFilter::label() const {
    if (extensions.empty()) return name;
    std::string list;
    for (const std::string& extension : extensions)
        list += (list.empty() ? "*" : " *") + extension;
    return fmt::format("{} ({})", name, list);
}

std::vector<FolderEntry> list_folder(const fs::path& folder, const FileFilter& filter,
                                     bool with_hidden, std::string& error) {
    error.clear();
    std::vector<FolderEntry> entries;
    std::error_code code;
    fs::directory_iterator it(folder, code);
    for (; !code && it != fs::directory_iterator(); it.increment(code)) {
        const std::string name = it->path().filename().string();
        if (!with_hidden && name.starts_with('.')) continue;
        struct stat status = {};
        if (stat(it->path().c_str(), &status) != 0) continue;
        const bool is_folder = S_ISDIR(status.st_mode);
        if (!is_folder && !(S_ISREG(status.st_mode) && filter.passes(name))) continue;
        entries.push_back({name, is_folder, is_folder ? 0 : static_cast<uintmax_t>(status.st_size),
                           std::chrono::system_clock::from_time_t(status.st_mtime)});
    }
    if (code) error = code.message();
    return entries;
}

void sort_entries(std::vector<FolderEntry>& entries, FolderOrder order, bool descending) {
    std::stable_sort(entries.begin(), entries.end(), [&](const auto& x, const auto& y) {
        if (x.is_folder != y.is_folder) return x.is_folder;
        const auto &a = descending ? y : x, &b = descending ? x : y;
        if (order == FolderOrder::Bytes && a.bytes != b.bytes) return a.bytes < b.bytes;
        if (order == FolderOrder::Time && a.time != b.time) return a.time < b.time;
        return comes_before(a.name, b.name);
    });
}

fs::path typed_path(const std::string& text, const fs::path& folder) {
    fs::path path = text;
    if (text == "~" || text.starts_with("~/")) {
        const char* home = std::getenv("HOME");
        path = fs::path(home ? home : "/") / (text.size() > 2 ? text.substr(2) : "");
    }
    return (folder / path).lexically_normal();
}

std::string bytes_text(uintmax_t bytes) {
    constexpr const char* kUnits[] = {"B", "KiB", "MiB", "GiB", "TiB"};
    auto size = static_cast<double>(bytes);
    size_t unit = 0;
    for (; size >= 1024 && unit + 1 < std::size(kUnits); ++unit)
        size /= 1024;
    return fmt::format("{:.{}f} {}", size, unit == 0 || size >= 100 ? 0 : 1, kUnits[unit]);
}

std::string time_text(std::chrono::system_clock::time_point time) {
    const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
    std::tm local = {};
    if (!localtime_r(&seconds, &local)) return "";
    return fmt::format("{:%Y-%m-%d %H:%M}", local);
}

}  // namespace tp
