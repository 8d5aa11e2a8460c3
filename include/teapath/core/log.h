// Log lines with levels, to stderr; spdlog stands behind, and is not seen here. Host only.
#pragma once

#include <fmt/format.h>

#include <string_view>

namespace tp {

enum class LogLevel { Debug, Info, Warning, Error };

/// Shows lines of this level and above. Thread-safe.
void set_log_level(LogLevel level);

/// Writes one line. Thread-safe.
void log_line(LogLevel level, std::string_view text);

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
