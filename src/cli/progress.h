// Shows a render's progress on stderr: a bar that is drawn again and again on a terminal, a line
// now and then elsewhere.
#pragma once

#include "progress_line.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace tp {

enum class ProgressStyle { Quiet, Lines, Bar };

/// Bar on a terminal that can draw one, else lines.
ProgressStyle progress_style_of_stderr();

struct ProgressGoal {
    int64_t samples = 0;  // per pixel; 0 = no limit
    double seconds = 0;   // 0 = no limit
    int64_t pixels = 0;
    int frames = 0;  // samples and seconds are those of each; 0 = one picture
};

/// A bar is drawn by a thread of its own, so that it lives through long steps.
class Progress {
public:
    /// `stopping` is asked, from any thread, whether the step under way is the last.
    Progress(ProgressStyle style, const ProgressGoal& goal, std::function<bool()> stopping);
    /// Takes the bar off the terminal.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// That many samples per pixel are done, of the frame under way.
    void update(int64_t done);
    /// The next frame begins; to be called before the first one too.
    void begin_frame();

    /// Seconds since the start.
    double seconds() const;

private:
    ProgressFacts facts() const;
    void add_frames(double now, ProgressFacts& facts) const;
    void draw_until_stopped();
    void draw_bar();
    void print_line();

    const ProgressStyle style_;
    const ProgressGoal goal_;
    const std::function<bool()> stopping_;
    const std::chrono::steady_clock::time_point start_;

    mutable std::mutex mutex_;  // guards what follows
    std::condition_variable wake_;
    bool ended_ = false;
    int64_t done_ = 0;         // of the frame under way
    int64_t done_before_ = 0;  // of the frames before it
    int frame_ = 0;            // from 1
    double frame_seconds_ = 0;
    double updated_seconds_ = 0;
    double line_seconds_ = 0;  // of the last line printed
    double line_share_ = 0;
    RateMeter meter_;

    std::thread drawer_;
};

}  // namespace tp
