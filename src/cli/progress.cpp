#include "progress.h"

#include "status.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace tp {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kRedrawPeriod = std::chrono::milliseconds(100);
constexpr const char* kEraseLine = "\r\x1b[K";

// A line for every tenth of the work or minute, but no more often than this.
constexpr double kLineShare = 0.1;
constexpr double kLineSeconds = 5;
constexpr double kLineLongestSeconds = 60;

std::string_view environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

// As the C library decides it: the first of the three that is set.
bool terminal_is_utf8() {
    for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
        const std::string_view value = environment(name);
        if (value.empty()) continue;
        return value.find("UTF-8") != value.npos || value.find("utf8") != value.npos;
    }
    return false;
}

int terminal_columns() {
    constexpr int kUsual = 80;
    winsize size = {};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kUsual;
    return size.ws_col;
}

// A job in the background leaves the terminal alone.
bool in_foreground() {
    return tcgetpgrp(STDERR_FILENO) == getpgrp();
}

}  // namespace

ProgressStyle progress_style_of_stderr() {
    const bool bar = isatty(STDERR_FILENO) != 0 && environment("TERM") != "dumb";
    return bar ? ProgressStyle::Bar : ProgressStyle::Lines;
}

Progress::Progress(ProgressStyle style, const ProgressGoal& goal, std::function<bool()> stopping)
    : style_(style), goal_(goal), stopping_(std::move(stopping)), start_(Clock::now()) {
    meter_.add(0, 0);
    if (style_ == ProgressStyle::Bar) drawer_ = std::thread([this] { draw_until_stopped(); });
}

Progress::~Progress() {
    if (!drawer_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
    }
    wake_.notify_all();
    drawer_.join();
    if (in_foreground()) print_status(kEraseLine);
}

double Progress::seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::update(int64_t done) {
    const std::lock_guard lock(mutex_);
    done_ = done;
    updated_seconds_ = seconds();
    meter_.add(updated_seconds_, done_before_ + done);
    if (style_ == ProgressStyle::Lines) print_line();
}

void Progress::begin_frame() {
    const std::lock_guard lock(mutex_);
    done_before_ += done_;
    done_ = 0;
    ++frame_;
    frame_seconds_ = seconds();
}

ProgressFacts Progress::facts() const {
    const double now = seconds();
    const double rate = meter_.rate();
    ProgressFacts facts;
    facts.done = done_;
    facts.target = goal_.samples;
    facts.stopping = stopping_();
    facts.frame = frame_;
    facts.frames = goal_.frames;
    facts.samples_per_second = rate * static_cast<double>(goal_.pixels);

    // Of the two limits, the one that comes first.
    if (goal_.samples > 0) {
        facts.share = static_cast<double>(done_) / static_cast<double>(goal_.samples);
        if (rate > 0) {
            const double needed = static_cast<double>(goal_.samples - done_) / rate;
            facts.seconds_left = std::max(0.0, needed - (now - updated_seconds_));
        }
    }
    if (goal_.seconds > 0) {
        const double spent = now - frame_seconds_;
        const double left = std::max(0.0, goal_.seconds - spent);
        facts.share = std::max(facts.share, std::min(1.0, spent / goal_.seconds));
        if (facts.seconds_left < 0 || left < facts.seconds_left) facts.seconds_left = left;
    }
    if (goal_.frames > 0) add_frames(now, facts);
    return facts;
}

// From the frame under way to all of them: those to come take as long as those so far.
void Progress::add_frames(double now, ProgressFacts& facts) const {
    const double share = (std::max(0, frame_ - 1) + facts.share) / goal_.frames;
    facts.share = share;
    facts.seconds_left = share > 0 ? now * (1 - share) / share : -1;
}

void Progress::draw_until_stopped() {
    std::unique_lock lock(mutex_);
    while (!ended_) {
        draw_bar();
        wake_.wait_for(lock, kRedrawPeriod, [&] { return ended_; });
    }
}

void Progress::draw_bar() {
    if (!in_foreground()) return;
    print_status(
        fmt::format("\r{}\x1b[K", progress_bar(facts(), terminal_columns(), terminal_is_utf8())));
}

void Progress::print_line() {
    const ProgressFacts now = facts();
    const double waited = updated_seconds_ - line_seconds_;
    const bool due = now.share >= line_share_ + kLineShare || waited >= kLineLongestSeconds;
    if (waited < kLineSeconds || !due) return;
    line_seconds_ = updated_seconds_;
    line_share_ = now.share;
    print_status(progress_text(now) + "\n");
}

}  // namespace tp
