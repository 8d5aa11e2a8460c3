#include <teapath/render/scheduler.h>

#include <algorithm>
#include <limits>

namespace tp {

int64_t next_samples(const StepHistory& history) {
    const int64_t left = history.target - history.done;
    if (left <= 0) return 0;
    if (history.last_samples <= 0) return 1;

    // What fits the budget at the measured rate, but no leap on the word of one measurement.
    constexpr int64_t kGrowth = 4;
    constexpr int64_t kMost = std::numeric_limits<int64_t>::max() / kGrowth;
    const int64_t most = std::min(left, kGrowth * std::min(history.last_samples, kMost));
    const double per_sample = history.last_seconds / static_cast<double>(history.last_samples);
    if (per_sample <= 0) return most;
    const double fitting = history.budget_seconds / per_sample;
    if (fitting >= static_cast<double>(most)) return most;
    return std::max<int64_t>(1, static_cast<int64_t>(fitting));
}

}  // namespace tp
