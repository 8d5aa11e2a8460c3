#include <teapath/core/log.h>

#include <fmt/chrono.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/dist_sink.h>
#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <deque>
#include <memory>
#include <mutex>

namespace tp {
namespace {

constexpr size_t kRememberedLines = 4096;
constexpr size_t kFileBytes = 1 << 20;
constexpr size_t kOlderFiles = 3;

LogLevel level_of(spdlog::level::level_enum level) {
    if (level >= spdlog::level::err) return LogLevel::Error;
    if (level == spdlog::level::warn) return LogLevel::Warning;
    return level == spdlog::level::info ? LogLevel::Info : LogLevel::Debug;
}

// Keeps the last lines for the console panel.
class MemorySink final : public spdlog::sinks::base_sink<std::mutex> {
public:
    std::vector<LogLine> lines_after(uint64_t serial) {
        const std::lock_guard lock(mutex_);
        std::vector<LogLine> lines;
        for (const LogLine& line : lines_)
            if (line.serial > serial) lines.push_back(line);
        return lines;
    }

private:
    void sink_it_(const spdlog::details::log_msg& message) override {
        const std::time_t time = spdlog::log_clock::to_time_t(message.time);
        lines_.push_back({++serial_, level_of(message.level),
                          fmt::format("{:%H:%M:%S}", fmt::localtime(time)),
                          std::string(message.payload.data(), message.payload.size())});
        if (lines_.size() > kRememberedLines) lines_.pop_front();
    }
    void flush_() override {}

    std::deque<LogLine> lines_;
    uint64_t serial_ = 0;
};

const std::shared_ptr<MemorySink>& memory_sink() {
    static const auto sink = std::make_shared<MemorySink>();
    return sink;
}

// Sinks can be added to this one while lines are written.
const std::shared_ptr<spdlog::sinks::dist_sink_mt>& file_sinks() {
    static const auto sink = std::make_shared<spdlog::sinks::dist_sink_mt>();
    return sink;
}

spdlog::logger& logger() {
    static const std::shared_ptr<spdlog::logger> instance = [] {
        const std::initializer_list<spdlog::sink_ptr> sinks = {
            std::make_shared<spdlog::sinks::stderr_color_sink_mt>(), memory_sink(), file_sinks()};
        auto made = std::make_shared<spdlog::logger>("teapath", sinks);
        made->set_pattern("%^%l%$: %v");
        return made;
    }();
    return *instance;
}

spdlog::level::level_enum level_of(LogLevel level) {
    switch (level) {
        case LogLevel::Debug: return spdlog::level::debug;
        case LogLevel::Info: return spdlog::level::info;
        case LogLevel::Warning: return spdlog::level::warn;
        case LogLevel::Error: return spdlog::level::err;
    }
    return spdlog::level::info;
}

}  // namespace

void set_log_level(LogLevel level) {
    logger().set_level(level_of(level));
}

std::string log_to_file(const std::string& file) {
    try {
        logger();  // sets the pattern of the sinks that are there, which is not that of the file
        auto sink =
            std::make_shared<spdlog::sinks::rotating_file_sink_mt>(file, kFileBytes, kOlderFiles);
        file_sinks()->set_sinks({sink});
        sink->set_pattern("%Y-%m-%d %H:%M:%S.%e %l: %v");
        logger().flush_on(spdlog::level::info);
        return {};
    } catch (const spdlog::spdlog_ex& error) {
        return error.what();
    }
}

std::vector<LogLine> log_lines_after(uint64_t serial) {
    return memory_sink()->lines_after(serial);
}

void log_line(LogLevel level, std::string_view text) {
    logger().log(level_of(level), text);
}

}  // namespace tp
