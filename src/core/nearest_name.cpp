#include <teapath/core/nearest_name.h>

#include <algorithm>
#include <cstddef>

namespace tp {
namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

// Optimal string alignment, row by row: `above` is one row up, `above2` two.
int edit_distance(std::string_view a, std::string_view b) {
    std::vector<int> above2, above(b.size() + 1), row(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j)
        above[j] = static_cast<int>(j);
    for (size_t i = 1; i <= a.size(); ++i) {
        row[0] = static_cast<int>(i);
        for (size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                                 lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) row[j] = std::min(row[j], above2[j - 2] + 1);
        }
        above2 = above;
        above = row;
    }
    return above[b.size()];
}

std::string nearest_name(std::string_view wrong, std::span<const std::string> names) {
    // A name is near if at most a third of it (and always one letter) is mistyped.
    constexpr size_t kLongestName = 200;
    if (wrong.size() > kLongestName) return {};
    std::string best;
    int best_distance = 0;
    for (const std::string& name : names) {
        if (name.size() > kLongestName) continue;
        const int distance = edit_distance(wrong, name);
        const int allowed = std::max(1, static_cast<int>(std::max(wrong.size(), name.size())) / 3);
        if (distance <= allowed && (best.empty() || distance < best_distance)) {
            best = name;
            best_distance = distance;
        }
    }
    return best;
}

}  // namespace tp
