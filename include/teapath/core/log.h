// Log lines with levels, to stderr; spdlog stands behind, and is not seen here. Host only.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

enum class LogLevel { Debug, Info, Warning, Error };

/// Shows lines of this level and above. Thread-safe.
void set_log_level(LogLevel level);

/// Also writes every line to this file from now on, with date and time: at most 1 MiB, then it
/// becomes "name.1.ext", and so on for three older ones. Returns what went wrong, or nothing.
std::string log_to_file(const std::string& file);

/// Writes one line. Thread-safe.
void log_line(LogLevel level, std::string_view text);

/// A line as it was written; the program remembers the last 4096.
struct LogLine {
    uint64_t serial = 0;  // counts up from 1
    LogLevel level = LogLevel::Info;
    std::string time;  // hh:mm:ss
    std::string text;
};

/// The remembered lines after `serial`, oldest first. Thread-safe.
std::vector<LogLine> log_lines_after(uint64_t serial);

template <class... Args>
void log_info(fmt::format_string<Args...> format, Args&&... args) {
    log_line(LogLevel::Info, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void log_warning(fmt::format_string<Args...> format, Args&&... args) {
    log_line(LogLevel::Warning, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void log_debug(fmt::format_string<Args...> format, Args&&... args) {
    log_line(LogLevel::Debug, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace tp
