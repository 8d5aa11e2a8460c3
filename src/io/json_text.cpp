#include "json_text.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>
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
                                        kMaxNesting, place_of(text, i + 1)),
                            name, "a scene needs fewer than 20");
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
}

// Builds the tree from the parser's events. The library's own builder does not see keys that stand
// twice, and with a callback takes quadratic time.
class TreeBuilder {
public:
    TreeBuilder(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    Json take() { return std::move(root_); }

    bool null() { return add(nullptr); }
    bool boolean(bool value) { return add(value); }
    bool number_integer(Json::number_integer_t value) { return add(value); }
    bool number_unsigned(Json::number_unsigned_t value) { return add(value); }
    bool number_float(Json::number_float_t value, const std::string&) { return add(value); }
    bool string(std::string& value) { return add(std::move(value)); }
    bool binary(Json::binary_t&) { return false; }  // not in text

    bool start_object(size_t) { return open(Json::object()); }
    bool start_array(size_t) { return open(Json::array()); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    bool key(std::string& key) {
        Level& level = levels_.back();
        level.key = key;
        if (!level.keys.insert(key).second)
            throw Error(ErrorKind::Input,
                        fmt::format("the key \"{}\" stands twice in one object", key),
                        name_ + ": " + path(), "remove one of them");
        return true;
    }

    bool parse_error(size_t position, const std::string& token, const Json::exception& error) {
        const std::string place = place_of(text_, position);
        if (dynamic_cast<const Json::out_of_range*>(&error))
            throw Error(ErrorKind::Input,
                        fmt::format("the number {} is too large at {}", token, place), name_,
                        "numbers stay below 1e308");
        throw Error(ErrorKind::Input, fmt::format("this is not valid JSON at {}", place), name_,
                    "look for a missing comma, quote or bracket just before; NaN and infinity are "
                    "not JSON");
    }

private:
    // An open object or list; an object with its keys so far.
    struct Level {
        Json* json;
        std::unordered_set<std::string> keys;
        std::string key;
    };

    // Puts a value where the events stand; returns its place, which stays while it is open.
    Json* place(Json value) {
        if (levels_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        Level& level = levels_.back();
        if (level.json->is_array()) {
            level.json->push_back(std::move(value));
            return &level.json->back();
        }
        // Behind the others without a search: the key is known to be new.
        auto& object = level.json->get_ref<Json::object_t&>();
        object.emplace_back(level.key, std::move(value));
        return &object.back().second;
    }

    bool add(Json value) {
        place(std::move(value));
        return true;
    }
    bool open(Json value) {
        levels_.push_back({place(std::move(value)), {}, {}});
        return true;
    }
    bool close() {
        levels_.pop_back();
        return true;
    }

    std::string path() const {
        std::string path;
        for (const Level& level : levels_) {
            if (level.json->is_array())
                path += fmt::format("[{}]", level.json->size() - 1);
            else
                path += (path.empty() ? "" : ".") + level.key;
        }
        return path;
    }

    std::string_view text_;
    const std::string& name_;
    Json root_;
    std::vector<Level> levels_;
};

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
    TreeBuilder builder(text, name);
    Json::sax_parse(text, &builder);
    return builder.take();
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

const char* type_name(const Json& json) {
    switch (json.type()) {
        case Json::value_t::null: return "null";
        case Json::value_t::object: return "an object";
        case Json::value_t::array: return "a list";
        case Json::value_t::string: return "a string";
        case Json::value_t::boolean: return "true or false";
        default: return "a number";
    }
}

}  // namespace tp
