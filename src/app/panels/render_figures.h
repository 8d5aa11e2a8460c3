// What metrics and status bar say of the render.
#pragma once

#include "../context.h"

#include <string>

namespace tp {

/// "0:42 left", "done", or nothing where it is not known.
std::string time_left_text(const PanelContext& c);

/// The share of the render that is done, 0 to 1: by samples or by time, whichever is nearer its
/// end.
double share_done(const PanelContext& c);

}  // namespace tp
