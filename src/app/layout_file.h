// Named layouts of the window in the user's configuration folder, one JSON file each. Knows no
// ImGui: what that says of places is a text.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

struct Layout {
    std::string name;
    std::vector<std::string> closed_panels;
    std::string places;  // ImGui's settings of windows and docks
    friend bool operator==(const Layout&, const Layout&) = default;
};

/// Why a layout cannot have that name; empty if it can.
std::string why_no_layout_name(std::string_view name);

/// Names of the layouts in the folder, sorted.
std::vector<std::string> layout_names(const std::filesystem::path& folder);

/// Throw Error(Input) for a layout that is not there or broken, Error(Output) where it cannot be
/// written.
Layout load_layout(const std::filesystem::path& folder, const std::string& name);
void save_layout(const std::filesystem::path& folder, const Layout& layout);
void delete_layout(const std::filesystem::path& folder, const std::string& name);

}  // namespace tp
