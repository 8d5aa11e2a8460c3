#include "help_format.h"

#include <fmt/format.h>

namespace tp {
namespace {

constexpr size_t kLineWidth = 80;

// `left` in its column, `right` beside it, broken at spaces.
std::string row(const std::string& left, const std::string& right, size_t column) {
    std::string text = "  " + left;
    text += left.size() + 3 > column ? "\n" + std::string(column, ' ')
                                     : std::string(column - text.size(), ' ');
    size_t used = column;
    for (size_t start = 0; start < right.size();) {
        const size_t space = std::min(right.find(' ', start), right.size());
        const std::string word = right.substr(start, space - start);
        if (used > column && used + 1 + word.size() > kLineWidth) {
            text += "\n" + std::string(column, ' ');
            used = column;
        }
        if (used > column) {
            text += ' ';
            ++used;
        }
        text += word;
        used += word.size();
        start = space + 1;
    }
    return text + "\n";
}

}  // namespace

std::string HelpFormat::make_help(const CLI::App* app, std::string name,
                                  CLI::AppFormatMode mode) const {
    std::string text = make_usage(app, std::move(name));
    text += "\n" + app->get_description() + "\n";
    text += make_positionals(app);
    text += make_subcommands(app, mode);
    text += make_groups(app, mode);
    if (!app->get_footer().empty()) text += "\n" + app->get_footer() + "\n";
    return text;
}

std::string HelpFormat::make_usage(const CLI::App* app, std::string) const {
    const std::string name = app->get_parent() ? "teapath " + app->get_name() : "teapath";
    return fmt::format("Usage: {} {}\n", name, usage_);
}

std::string HelpFormat::make_option(const CLI::Option* option, bool positional) const {
    std::string left = option->get_name(positional, true);
    if (const size_t comma = left.find(','); comma != std::string::npos)
        left.insert(comma + 1, " ");
    if (!positional && !option->get_option_text().empty()) left += " " + option->get_option_text();
    return row(left, option->get_description(), get_column_width());
}

std::string HelpFormat::make_subcommand(const CLI::App* command) const {
    return row(command->get_name(), command->get_description(), get_column_width());
}

}  // namespace tp
