#include "progress_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace tp {
namespace {

constexpr double kWindowSeconds = 10;

// A bar of `width` cells, in eighths of a cell where the terminal can show them.
std::string bar(double share, int width, bool unicode) {
    static constexpr std::array<std::string_view, 8> kEighths = {"",  "▏", "▎", "▍",
                                                                 "▌", "▋", "▊", "▉"};
    const int eighths = static_cast<int>(std::clamp(share, 0.0, 1.0) * width * 8);
    const int full = eighths / 8;
    std::string text;
    for (int i = 0; i < full; ++i)
        text += unicode ? "█" : "#";
    int used = full;
    if (unicode && eighths % 8 != 0) {
        text += kEighths[static_cast<size_t>(eighths % 8)];
        ++used;
    }
    for (; used < width; ++used)
        text += unicode ? " " : ".";
    return unicode ? "▕" + text + "▏" : "[" + text + "]";
}

std::string samples_text(ProgressFacts facts) {
    if (facts.frames > 0) {
        const std::string frame = fmt::format("frame {}/{}  ", facts.frame, facts.frames);
        facts.frames = 0;
        return frame + samples_text(facts);
    }
    if (facts.target == 0) return fmt::format("{} spp", facts.done);
    return fmt::format("{}/{} spp", facts.done, facts.target);
}

std::string left_text(const ProgressFacts& facts) {
    if (facts.stopping) return "stopping after this step";
    if (facts.seconds_left < 0) return "";
    return duration_text(std::ceil(facts.seconds_left)) + " left";
}

int percent(const ProgressFacts& facts) {
    return static_cast<int>(std::clamp(facts.share, 0.0, 1.0) * 100);
}

}  // namespace

std::string duration_text(double seconds) {
    constexpr double kLongest = 1000.0 * 3600;
    if (seconds >= kLongest) return fmt::format("{:.0f} days", seconds / (24 * 3600));
    const auto whole = static_cast<int64_t>(std::max(0.0, seconds));
    if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string rate_text(double samples_per_second) {
    const bool mega = samples_per_second >= 1e6;
    const double value = samples_per_second / (mega ? 1e6 : 1e3);
    const int decimals = value < 10 ? 2 : value < 100 ? 1 : 0;
    return fmt::format("{:.{}f} {}samples/s", value, decimals, mega ? "M" : "k");
}

std::string progress_bar(const ProgressFacts& facts, int columns, bool unicode) {
    // All the facts, then fewer until they fit; what room is left is the bar's.
    std::string rate = facts.samples_per_second > 0 ? rate_text(facts.samples_per_second) : "";
    std::string left = left_text(facts);
    const std::string share = fmt::format("{:3} %", percent(facts));
    const std::string samples = samples_text(facts);
    const auto joined = [&] {
        std::string text = share + "  " + samples;
        if (!rate.empty()) text += "  " + rate;
        if (!left.empty()) text += "  " + left;
        return text;
    };
    const auto room = static_cast<size_t>(std::max(1, columns - 1));
    if (joined().size() > room) rate.clear();
    if (joined().size() > room) left.clear();
    const std::string text = joined();
    if (text.size() > room) return share.size() <= room ? share : "";

    constexpr int kFrame = 3;  // two ends and a space
    constexpr int kShortest = 8;
    constexpr int kLongest = 40;
    const int width = std::min(kLongest, static_cast<int>(room - text.size()) - kFrame);
    return width < kShortest ? text : bar(facts.share, width, unicode) + " " + text;
}

std::string progress_text(const ProgressFacts& facts) {
    std::string text = fmt::format("{:3} %  {}", percent(facts), samples_text(facts));
    if (facts.samples_per_second > 0) text += "  " + rate_text(facts.samples_per_second);
    if (const std::string left = left_text(facts); !left.empty()) text += "  " + left;
    return text;
}

void RateMeter::add(double seconds, int64_t done) {
    marks_.push_back({seconds, done});
    // The start of the first step goes once there is a second one.
    if (!warm_ && marks_.size() == 3) {
        marks_.pop_front();
        warm_ = true;
    }
    while (marks_.size() > 2 && marks_[1].seconds < seconds - kWindowSeconds)
        marks_.pop_front();
}

double RateMeter::rate() const {
    if (marks_.size() < 2) return 0;
    const double seconds = marks_.back().seconds - marks_.front().seconds;
    const auto samples = static_cast<double>(marks_.back().done - marks_.front().done);
    return seconds > 0 ? samples / seconds : 0;
}

}  // namespace tp
