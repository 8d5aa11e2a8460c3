// One command of the program, such as `teapath render`.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace tp {

struct Command {
    CLI::App* parser = nullptr;  // owned by the program's parser
    std::function<int()> run;    // after parsing; returns the exit code, throws Error
};

/// Each adds its command to the program's parser.
Command add_render_command(CLI::App& program);
Command add_info_command(CLI::App& program);
Command add_random_command(CLI::App& program);

}  // namespace tp
