// Steps of a session until a goal is reached or the user has had enough.
#pragma once

#include "progress.h"

#include <teapath/render/session.h>

#include <functional>

namespace tp {

/// Adds samples until the goal's samples or seconds are reached or `stop` answers true; at least
/// one sample. Returns the seconds that it took.
double render_until(Session& session, const ProgressGoal& goal, Progress& progress,
                    const std::function<bool()>& stop);

}  // namespace tp
