// Names that differ: paths of the parts of a model.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace tp {

/// A name as a piece of a path: without slashes, and short.
inline std::string path_piece(std::string_view name) {
    std::string piece(name.substr(0, 200));
    for (char& c : piece)
        if (c == '/' || c == '#') c = '_';
    return piece;
}

class UniqueNames {
public:
    /// The name, or if it was given before "NAME 2", "NAME 3" and so on.
    std::string add(std::string name) {
        if (used_.insert(name).second) return name;
        size_t& count = counts_[name];
        if (count == 0) count = 1;
        for (;;) {
            std::string next = fmt::format("{} {}", name, ++count);
            if (used_.insert(next).second) return next;
        }
    }

private:
    std::unordered_set<std::string> used_;
    std::unordered_map<std::string, size_t> counts_;
};

}  // namespace tp
