#include "figures.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

namespace tp {

std::string memory_text(size_t bytes) {
    const char* const units[] = {"B", "KiB", "MiB", "GiB", "TiB"};
    auto value = static_cast<double>(bytes);
    size_t unit = 0;
    while (value >= 1024 && unit + 1 < std::size(units)) {
        value /= 1024;
        ++unit;
    }
    return fmt::format("{:.{}f} {}", value, unit == 0 || value >= 99.95 ? 0 : 1, units[unit]);
}

std::string count_text(double count) {
    const char* const prefixes[] = {"", "k", "M", "G", "T"};
    size_t prefix = 0;
    while (count >= 999.5 && prefix + 1 < std::size(prefixes)) {
        count /= 1000;
        ++prefix;
    }
    return fmt::format("{:.{}f} {}", count, count >= 99.95 || prefix == 0 ? 0 : 1,
                       prefixes[prefix]);
}

std::string clock_time(double seconds) {
    if (!std::isfinite(seconds) || seconds > 3.6e8) return "days";
    const auto whole = static_cast<int64_t>(std::max(0.0, seconds) + 0.5);
    if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

float quantile(std::span<const float> values, double share) {
    if (values.empty()) return 0;
    std::vector<float> sorted(values.begin(), values.end());
    const auto at =
        static_cast<size_t>(std::clamp(std::ceil(share * static_cast<double>(sorted.size())) - 1,
                                       0.0, static_cast<double>(sorted.size() - 1)));
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(at),
                     sorted.end());
    return sorted[at];
}

size_t process_memory() {
    std::ifstream in("/proc/self/statm");
    size_t pages = 0, resident = 0;
    if (!(in >> pages >> resident)) return 0;
    return resident * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace tp
