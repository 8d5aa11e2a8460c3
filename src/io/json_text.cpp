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
        using Event = Json::parse_event_t;
        if (event == Event::object_start || event == Event::array_start) levels_.emplace_back();
        if (event == Event::object_end || event == Event::array_end) {
            levels_.pop_back();
            count_element();
        }
        if (event == Event::value) count_element();
        if (event == Event::key) {
            Level& level = levels_.back();
            level.key = parsed.get<std::string>();
            if (!level.keys.insert(level.key).second)
                throw Error(ErrorKind::Input,
                            fmt::format("the key \"{}\" stands twice in one object", level.key),
                            name_ + ": " + path(), "remove one of them");
        }
        return true;
    }

private:
    // An open object with its keys so far, or an open list with the number of elements.
    struct Level {
        std::set<std::string> keys;
        std::string key;
        size_t count = 0;
    };

    void count_element() {
        if (!levels_.empty()) ++levels_.back().count;
    }

    std::string path() const {
        std::string path;
        for (const Level& level : levels_) {
            if (level.keys.empty())
                path += fmt::format("[{}]", level.count);
            else
                path += (path.empty() ? "" : ".") + level.key;
        }
        return path;
    }

    const std::string& name_;
    std::vector<Level> levels_;
};

// What the parser says of a number that is out of range ends in the number: "… 'parsing '1e400'".
std::string number_in(const std::string& message) {
    const size_t last = message.rfind('\'');
    const size_t first = last == std::string::npos ? last : message.rfind('\'', last - 1);
    return first == std::string::npos ? std::string() : message.substr(first + 1, last - first - 1);
}

// A string or number as JSON; bytes that are no UTF-8 become the replacement character.
std::string plain(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// One line, with a space after commas and colons.
std::string spaced(const Json& json) {
    if (!json.is_structured()) return plain(json);
    std::string text = json.is_object() ? "{" : "[";
    bool first = true;
    for (const auto& [key, value] : json.items()) {
        if (!first) text += ", ";
        first = false;
        if (json.is_object()) text += plain(key) + ": ";
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
    } catch (const Json::out_of_range& error) {
        const std::string number = number_in(error.what());
        const size_t at = text.find(number);
        throw Error(ErrorKind::Input,
                    fmt::format("the number {} is too large{}", number,
                                at == std::string_view::npos || number.empty()
                                    ? ""
                                    : " at " + place_of(text, at + 1)),
                    name, "numbers stay below 1e308");
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
        if (json.is_object()) text += plain(key) + ": ";
        text += pretty_json(value, indent + 2);
    }
    return text + "\n" + std::string(margin, ' ') + (json.is_object() ? "}" : "]");
}

}  // namespace tp
