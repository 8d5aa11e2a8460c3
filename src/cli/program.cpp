// The program's parser: commands, help, and what to say about a command line that is wrong.
#include "command.h"
#include "help_format.h"
#include "status.h"
#include "version.h"

#include <teapath/cli/program.h>
#include <teapath/core/error.h>
#include <teapath/core/nearest_name.h>
#include <teapath/io/image_file.h>
#include <teapath/io/model_file.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace tp {
namespace {

constexpr const char* kProgramFooter = R"(Examples:
  teapath render scenes/cornell_box.json -o box.png
  teapath info scenes/cornell_box.json
  teapath render --help

Exit codes: 0 done, 2 wrong command line, 3 bad input, 4 device missing, lost or
full, 5 output cannot be written, 130 interrupted (what was there is saved),
1 a fault of the program.)";

std::vector<std::string> command_names(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    return names;
}

std::string did_you_mean(const std::string& wrong, const std::vector<std::string>& names) {
    const std::string nearest = nearest_name(wrong, names);
    return nearest.empty() ? std::string() : fmt::format("did you mean '{}'? ", nearest);
}

[[noreturn]] void throw_unknown_command(const CLI::App& program, const std::string& word) {
    if (std::filesystem::path(word).extension() == ".json" || can_read_model(word)) {
        throw Error(ErrorKind::Usage, fmt::format("'{}' is not a command", word), "",
                    fmt::format("to render it: teapath render {} -o image.png", word));
    }
    const auto names = command_names(program);
    throw Error(ErrorKind::Usage, fmt::format("there is no command '{}'", word), "",
                fmt::format("{}commands are {}; see teapath --help", did_you_mean(word, names),
                            fmt::join(names, ", ")));
}

// What the command did not expect: an option that it has not, or one word too many.
[[noreturn]] void throw_unexpected(const CLI::App& command, const std::string& word) {
    const std::string help = fmt::format("see teapath {} --help", command.get_name());
    if (word.starts_with('-')) {
        const std::string name = word.substr(0, word.find('='));
        throw Error(ErrorKind::Usage,
                    fmt::format("teapath {} has no option {}", command.get_name(), name), "",
                    did_you_mean(name, option_names(command)) + help);
    }
    const std::string hint =
        can_write_image(word) ? fmt::format("to write that picture: -o {}; ", word) : "";
    throw Error(
        ErrorKind::Usage,
        fmt::format("teapath {} does not know what to do with '{}'", command.get_name(), word), "",
        hint + help);
}

// An error of the parser itself, in our words.
[[noreturn]] void throw_parse_error(const CLI::App& command, const CLI::ParseError& error) {
    const std::string name = command.get_parent() ? "teapath " + command.get_name() : "teapath";
    const std::string help = fmt::format("see {} --help", name);
    const std::string text = error.what();
    // "--spp: 1 required TEXT missing"
    const size_t colon = text.find(": ");
    if (error.get_name() == "ArgumentMismatch" && colon != std::string::npos)
        throw Error(ErrorKind::Usage, "its value is missing", text.substr(0, colon), help);
    throw Error(ErrorKind::Usage, text, "", help);
}

const CLI::App& deepest_parsed(const CLI::App& program) {
    const auto parsed = program.get_subcommands();
    return parsed.empty() ? program : *parsed.front();
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
    CLI::App program("Teapath, a path tracer: renders scenes on NVIDIA GPUs and on the host.",
                     "teapath");
    program.formatter(std::make_shared<HelpFormat>("COMMAND [OPTIONS]"));
    program.set_help_flag("-h,--help", "Print this help");
    program.set_version_flag("--version", version_line(), "Print version and build");
    program.footer(kProgramFooter);
    program.allow_extras();
    program.require_subcommand(0, 1);
    program.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);

    const std::array commands = {add_render_command(program), add_info_command(program),
                                 add_random_command(program)};

    // Without a command there is nothing to do yet: say what there is.
    if (argc < 2) {
        print_status(program.help());
        return static_cast<int>(ErrorKind::Usage);
    }
    try {
        program.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        print_result(deepest_parsed(program).help());
        return 0;
    } catch (const CLI::CallForVersion&) {
        print_result(version_line() + "\n");
        return 0;
    } catch (const CLI::ParseError& error) {
        throw_parse_error(deepest_parsed(program), error);
    }

    for (const Command& command : commands) {
        if (!command.parser->parsed()) continue;
        const auto unexpected = command.parser->remaining();
        if (!unexpected.empty()) throw_unexpected(*command.parser, unexpected.front());
        return command.run();
    }
    const auto unexpected = program.remaining();
    const std::string word = unexpected.empty() ? argv[1] : unexpected.front();
    if (!word.starts_with('-')) throw_unknown_command(program, word);
    throw Error(ErrorKind::Usage, fmt::format("teapath has no option {}", word), "",
                did_you_mean(word, option_names(program)) +
                    "options of a command follow it; see teapath --help");
}

}  // namespace tp
