// How help looks: usage, then arguments and options in one column, examples last.
#pragma once

#include <CLI/Formatter.hpp>

#include <string>

namespace tp {

class HelpFormat : public CLI::Formatter {
public:
    /// `usage` is what follows the command's name, as in "SCENE -o FILE [OPTIONS]".
    explicit HelpFormat(std::string usage) : usage_(std::move(usage)) {
        column_width(28);
        label("Subcommands", "Commands");
        label("Positionals", "Arguments");
    }

    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override;
    std::string make_usage(const CLI::App* app, std::string name) const override;
    std::string make_option(const CLI::Option* option, bool positional) const override;
    std::string make_subcommand(const CLI::App* command) const override;

private:
    std::string usage_;
};

}  // namespace tp
