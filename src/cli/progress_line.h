// What a render says while it runs: pure functions from numbers to text.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

namespace tp {

struct ProgressFacts {
    int64_t done = 0;               // samples per pixel
    int64_t target = 0;             // samples per pixel; 0 = as many as the time allows
    double share = 0;               // of the work, 0 to 1
    double samples_per_second = 0;  // camera samples of all pixels; 0 = not known yet
    double seconds_left = -1;       // below 0 = not known yet
    bool stopping = false;          // interrupted: the step under way is the last
    int frame = 0, frames = 0;      // the one under way, from 1, of so many; 0 = no frames
};

/// "0:07", "12:05", "1:02:03".
std::string duration_text(double seconds);

/// "4.21 Msamples/s", with three digits and a fitting unit.
std::string rate_text(double samples_per_second);

/// One line for a terminal of that many columns, never longer, with a bar where there is room;
/// `unicode`: the terminal shows UTF-8.
std::string progress_bar(const ProgressFacts& facts, int columns, bool unicode);

/// One line for a log.
std::string progress_text(const ProgressFacts& facts);

/// The rate over the last seconds of a render. The first step, which also warms up, counts only
/// until there are others.
class RateMeter {
public:
    /// `done` samples per pixel had been taken at `seconds`; both never decrease.
    void add(double seconds, int64_t done);

    /// Samples per pixel and second; 0 = not known yet.
    double rate() const;

private:
    struct Mark {
        double seconds;
        int64_t done;
    };
    std::deque<Mark> marks_;
    bool warm_ = false;
};

}  // namespace tp
