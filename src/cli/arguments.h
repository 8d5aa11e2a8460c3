// Values of options as the user types them. Each throws Error(Usage) that names the option, what
// is wrong and what it takes.
#pragma once

#include <teapath/render/backend.h>

#include <cstdint>
#include <string>

namespace tp {

struct ImageSize {
    int width = 0;
    int height = 0;
};

/// A whole number in [low, high], decimal.
int64_t parse_whole(const std::string& option, const std::string& text, int64_t low, int64_t high);

/// Seconds above 0, fractions allowed.
double parse_seconds(const std::string& option, const std::string& text);

/// Frames a second above 0, fractions allowed.
double parse_frame_rate(const std::string& option, const std::string& text);

/// "1920x1080".
ImageSize parse_size(const std::string& option, const std::string& text);

/// Frames from the first to the last.
struct FrameRange {
    int first = 0, last = 0;
    int count() const { return last - first + 1; }
};

/// "0-47", or one frame, "12"; from 0 to 999,999.
FrameRange parse_frames(const std::string& option, const std::string& text);

/// A whole number from 0 to 2^64 - 1, or "random": taken from the clock.
uint64_t parse_seed(const std::string& option, const std::string& text);

/// "auto", "cuda" or "host".
BackendKind parse_backend(const std::string& option, const std::string& text);

}  // namespace tp
