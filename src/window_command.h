// `teapath [SCENE]`: the window, where this build has one.
#pragma once

#include <optional>

namespace tp {

/// Runs the window if the command line asks for it: no arguments, or a scene file first. Nothing
/// otherwise, and in builds without a window. Returns the exit code; throws Error.
std::optional<int> run_window_command(int argc, char** argv);

}  // namespace tp
