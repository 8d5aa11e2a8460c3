// The command line program: finds the command and runs it.
#pragma once

namespace tp {

/// Runs `teapath ARGUMENTS` and returns its exit code: 0, or 130 if the user interrupted it. Throws
/// Error, whose exit_code() says the rest: 2 usage, 3 input, 4 device, 5 output.
int run_command_line(int argc, const char* const* argv);

}  // namespace tp
