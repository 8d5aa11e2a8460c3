// Jobs in the interface: their results, and the list of those that run.
#pragma once

#include "../context.h"

namespace tp {

/// Runs what ended jobs left to do; an error without a handler is a notice.
void finish_jobs(PanelContext& c);

/// The running jobs with progress and cancel, in the line of the status bar.
void draw_jobs(PanelContext& c);

}  // namespace tp
