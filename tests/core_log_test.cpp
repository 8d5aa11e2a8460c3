// The log's memory and its file.
#include <teapath/core/log.h>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

using namespace tp;

namespace {

std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("log: lines are remembered as they were written, with their level") {
    const auto before = log_lines_after(0);
    const uint64_t serial = before.empty() ? 0 : before.back().serial;
    log_line(LogLevel::Warning, "100 %s of %n {} %d");
    const auto lines = log_lines_after(serial);
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].text == "100 %s of %n {} %d");
    CHECK(lines[0].level == LogLevel::Warning);
    CHECK(lines[0].time.size() == 8);
}

TEST_CASE("log: lines go to a file too, those below the level do not") {
    const auto folder = std::filesystem::temp_directory_path() / "teapath_log_test";
    std::filesystem::remove_all(folder);
    const auto file = folder / "teapath.log";  // the folder is made
    CHECK(log_to_file(file.string()).empty());
    log_line(LogLevel::Warning, "a line for the file");
    CHECK(text_of(file).find("warning: a line for the file") != std::string::npos);
    set_log_level(LogLevel::Info);
    const std::string long_line(20'000, 'x');
    for (int i = 0; i < 120; ++i)
        log_line(LogLevel::Debug, long_line);  // below the level: nowhere
    CHECK(std::filesystem::file_size(file) < 1000);
    CHECK(!log_to_file("/proc/no/such/place.log").empty());
    std::filesystem::remove_all(folder);
}
