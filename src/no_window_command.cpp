// Stands in for the window in builds without it.
#include "window_command.h"

namespace tp {

std::optional<int> run_window_command(int, char**) {
    return std::nullopt;
}

}  // namespace tp
