#include "arguments.h"

#include <teapath/core/error.h>
#include <teapath/render/backend_names.h>
#include <teapath/scene/scene.h>

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>

namespace tp {
namespace {

// The number that `text` is as a whole, or nothing.
template <class Number>
std::optional<Number> number(const std::string& text) {
    Number value{};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

bool is_digits(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

// Spreads the clock's nanoseconds over 32 bits, few enough to type again.
uint64_t seed_from_clock() {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    auto x = static_cast<uint64_t>(std::chrono::nanoseconds(now).count());
    x = (x ^ (x >> 31)) * 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio: an odd multiplier
    return x >> 32;
}

}  // namespace

int64_t parse_whole(const std::string& option, const std::string& text, int64_t low, int64_t high) {
    const std::string range = fmt::format("give a whole number from {} to {}", low, high);
    const auto value = number<int64_t>(text);
    const bool too_long = is_digits(text) || (text.starts_with('-') && is_digits(text.substr(1)));
    if (!value && !too_long)
        throw Error(ErrorKind::Usage, fmt::format("'{}' is not a whole number", text), option,
                    range);
    if (!value || *value < low || *value > high)
        throw Error(ErrorKind::Usage, fmt::format("{} is out of range", text), option, range);
    return *value;
}

double parse_seconds(const std::string& option, const std::string& text) {
    constexpr double kLongest = 1e9;
    const auto value = number<double>(text);
    if (!value || !(*value > 0) || *value > kLongest)
        throw Error(ErrorKind::Usage, fmt::format("'{}' is not a time", text), option,
                    "give seconds above 0, as in 90 or 2.5");
    return *value;
}

double parse_frame_rate(const std::string& option, const std::string& text) {
    const auto value = number<double>(text);
    if (!value || !(*value > 0.001) || !(*value <= 1e6))
        throw Error(ErrorKind::Usage, fmt::format("'{}' is no number of frames", text), option,
                    "give frames a second, as in 24 or 29.97");
    return *value;
}

ImageSize parse_size(const std::string& option, const std::string& text) {
    const size_t cross = text.find_first_of("xX");
    const std::string width = text.substr(0, cross);
    const std::string height = cross == std::string::npos ? "" : text.substr(cross + 1);
    if (!is_digits(width) || !is_digits(height))
        throw Error(ErrorKind::Usage, fmt::format("'{}' is not a size", text), option,
                    "give width and height in pixels, as in 1920x1080");
    return {static_cast<int>(parse_whole(option, width, 1, kMaxImageSide)),
            static_cast<int>(parse_whole(option, height, 1, kMaxImageSide))};
}

FrameRange parse_frames(const std::string& option, const std::string& text) {
    constexpr int kLastFrame = 999'999;
    const size_t dash = text.find('-');
    const std::string first = text.substr(0, dash);
    const std::string last = dash == std::string::npos ? first : text.substr(dash + 1);
    if (!is_digits(first) || !is_digits(last))
        throw Error(ErrorKind::Usage, fmt::format("'{}' is no range of frames", text), option,
                    "give the first and the last, as in 0-47");
    const FrameRange range{static_cast<int>(parse_whole(option, first, 0, kLastFrame)),
                           static_cast<int>(parse_whole(option, last, 0, kLastFrame))};
    if (range.last < range.first)
        throw Error(ErrorKind::Usage, fmt::format("'{}' ends before it begins", text), option,
                    "give the first and the last, as in 0-47");
    return range;
}

uint64_t parse_seed(const std::string& option, const std::string& text) {
    if (text == "random") return seed_from_clock();
    const auto value = number<uint64_t>(text);
    if (!value)
        throw Error(ErrorKind::Usage, fmt::format("'{}' is not a seed", text), option,
                    "give a whole number from 0 to 18446744073709551615, or random");
    return *value;
}

BackendKind parse_backend(const std::string& option, const std::string& text) {
    if (const auto kind = enum_value<BackendKind>(text)) return *kind;
    throw Error(ErrorKind::Usage, fmt::format("there is no backend '{}'", text), option,
                fmt::format("give one of {}", enum_names<BackendKind>()));
}

}  // namespace tp
