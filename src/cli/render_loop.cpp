#include "render_loop.h"

#include <teapath/render/rendered_image.h>

namespace tp {

double render_until(Session& session, const ProgressGoal& goal, Progress& progress,
                    const std::function<bool()>& stop) {
    return render_until(
        session, {goal.samples, goal.seconds}, [&](int64_t done) { progress.update(done); }, stop);
}

}  // namespace tp
