#include <teapath/render/scheduler.h>

#include <algorithm>

namespace tp {

int64_t next_samples(const StepHistory& history) {
    const int64_t left = history.target - history.done;
    if (left <= 0) return 0;
    if (history.last_samples <= 0) return 1;

    // What fits the budget at the measured rate, but no leap on the word of one measurement.
    const int64_t most = history.last_samples * 4;
    const double per_sample = history.last_seconds / static_cast<double>(history.last_samples);
    const double fitting =
        per_sample > 0 ? history.budget_seconds / per_sample : static_cast<double>(most);
    const auto wanted = static_cast<int64_t>(std::clamp(fitting, 1.0, static_cast<double>(most)));
    return std::min(wanted, left);
}

}  // namespace tp
