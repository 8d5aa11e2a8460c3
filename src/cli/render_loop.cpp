#include "render_loop.h"

#include <teapath/render/scheduler.h>

#include <algorithm>
#include <limits>

namespace tp {
namespace {

// Short enough that Ctrl-C feels prompt, long enough that a step's fixed cost does not count.
constexpr double kStepSeconds = 0.25;

}  // namespace

double render_until(Session& session, const ProgressGoal& goal, Progress& progress,
                    const std::function<bool()>& stop) {
    StepHistory history;
    history.target = goal.samples > 0 ? goal.samples : std::numeric_limits<int64_t>::max();
    double now = progress.seconds();
    for (;;) {
        const double left = goal.seconds > 0 ? goal.seconds - now : kStepSeconds;
        history.budget_seconds = std::clamp(left, 0.0, kStepSeconds);
        const int64_t samples = next_samples(history);
        if (samples == 0) break;

        const double before = now;
        session.step(samples);
        now = progress.seconds();
        history.done += samples;
        history.last_samples = samples;
        history.last_seconds = now - before;
        progress.update(history.done);

        // The next sample is not worth starting if most of it would lie past the end.
        const double sample_seconds = history.last_seconds / static_cast<double>(samples);
        if (stop()) break;
        if (goal.seconds > 0 && now + sample_seconds / 2 >= goal.seconds) break;
    }
    return now;
}

}  // namespace tp
