#include "json_text.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

namespace tp {
namespace {

constexpr int kMaxNesting = 200;

// "line 3, column 14" of a byte offset.
std::string place_of(std::string_view text, size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const size_t start = before.find_last_of('\n');
    const size_t column = before.size() - (start == std::string_view::npos ? 0 : start + 1);
    return fmt::format("line {}, column {}", line, std::max<size_t>(column, 1));
}

// The parser recurses on nothing, but what walks the tree later does.
void check_nesting(std::string_view text, const std::string& name) {
    int depth = 0;
    bool in_string = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') ++i;
            if (c == '"') in_string = false;
        } else if (c == '"') {
            in_string = true;
        } else if (c == '{' || c == '[') {
            if (++depth > kMaxNesting)
                throw Error(ErrorKind::Input,
                            fmt::format("lists and objects nest deeper than {} levels at {}",
                                        kMaxNesting, place_of(text, i)),
                            name, "a scene needs fewer than 20");
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
}

// Refuses a key that stands twice in one object.
class DuplicateCheck {
public:
    explicit DuplicateCheck(const std::string& name) : name_(name) {}

    bool operator()(int, Json::parse_event_t event, Json& parsed) {
        if (event == Json::parse_event_t::object_start) keys_.emplace_back();
        if (event == Json::parse_event_t::object_end) keys_.pop_back();
        if (event == Json::parse_event_t::key &&
            !keys_.back().insert(parsed.get<std::string>()).second)
            throw Error(
                ErrorKind::Input,
                fmt::format("the key \"{}\" stands twice in one object", parsed.get<std::string>()),
                name_, "remove one of them");
        return true;
    }

private:
    const std::string& name_;
    std::vector<std::set<std::string>> keys_;
};

// One line, with a space after commas and colons.
std::string spaced(const Json& json) {
    if (!json.is_structured()) return json.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::string text = json.is_object() ? "{" : "[";
    bool first = true;
    for (const auto& [key, value] : json.items()) {
        if (!first) text += ", ";
        first = false;
        if (json.is_object())
            text += Json(key).dump(-1, ' ', false, Json::error_handler_t::replace) + ": ";
        text += spaced(value);
    }
    return text + (json.is_object() ? "}" : "]");
}

}  // namespace

Json parse_json(std::string_view text, const std::string& name) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        throw Error(ErrorKind::Input, "the file is empty", name,
                    "a scene is a JSON object; docs/scene_format.md has an example");
    check_nesting(text, name);
    try {
        return Json::parse(text, DuplicateCheck(name));
    } catch (const Json::parse_error& error) {
        throw Error(ErrorKind::Input,
                    fmt::format("this is not valid JSON at {}", place_of(text, error.byte)), name,
                    "look for a missing comma, quote or bracket just before; NaN and infinity are "
                    "not JSON");
    } catch (const Json::out_of_range&) {
        throw Error(ErrorKind::Input, "a number is too large to be represented", name,
                    "numbers stay below 1e308");
    }
}

std::string pretty_json(const Json& json, int indent) {
    constexpr size_t kColumns = 100;
    std::string flat = spaced(json);
    const auto margin = static_cast<size_t>(indent);
    if (!json.is_structured() || json.empty() || (indent > 0 && margin + flat.size() <= kColumns))
        return flat;
    const std::string pad(margin + 2, ' ');
    std::string text = json.is_object() ? "{" : "[";
    bool first = true;
    for (const auto& [key, value] : json.items()) {
        text += first ? "\n" : ",\n";
        first = false;
        text += pad;
        if (json.is_object()) text += Json(key).dump() + ": ";
        text += pretty_json(value, indent + 2);
    }
    return text + "\n" + std::string(margin, ' ') + (json.is_object() ? "}" : "]");
}

}  // namespace tp
