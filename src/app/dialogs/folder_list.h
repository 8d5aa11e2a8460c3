// What the file browser shows of a folder. Knows no ImGui.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tp {

/// Files of some kind: "Scenes", {".json"}. No extensions: every file.
struct FileFilter {
    std::string name;
    std::vector<std::string> extensions;  // lower case, with the dot

    /// True if the name ends in one of them, in any case.
    bool passes(const std::filesystem::path& file) const;
    /// "Scenes (*.json)".
    std::string label() const;
};

struct FolderEntry {
    std::string name;
    bool is_folder = false;
    uintmax_t bytes = 0;  // of a file
    std::chrono::system_clock::time_point time;
};

enum class FolderOrder : uint8_t { Name, Bytes, Time };

/// Folders and the files that pass the filter; those with a dot first only if `with_hidden`.
/// `error` says why a folder cannot be listed. Entries that cannot be looked at are left out.
std::vector<FolderEntry> list_folder(const std::filesystem::path& folder, const FileFilter& filter,
                                     bool with_hidden, std::string& error);

/// Folders first, names in the order of people ("a2" before "a10", any case).
void sort_entries(std::vector<FolderEntry>& entries, FolderOrder order, bool descending);

/// What was typed as a path, from `folder` on: "~" is the home folder.
std::filesystem::path typed_path(const std::string& text, const std::filesystem::path& folder);

/// "1.2 MiB".
std::string bytes_text(uintmax_t bytes);
/// Local date and time: "2026-11-25 22:31".
std::string time_text(std::chrono::system_clock::time_point time);

}  // namespace tp
