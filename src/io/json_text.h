// JSON text to a tree, with errors that say line and column, and limits that a hostile file cannot
// pass.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace tp {

using Json = nlohmann::ordered_json;

/// Parses; throws Error(Input) for broken text, nesting beyond 200 levels, duplicate keys, numbers
/// out of range. `name` stands for the file.
Json parse_json(std::string_view text, const std::string& name);

/// What kind of value it is, for messages: "a list", "a number".
const char* type_name(const Json& json);

/// The text of a tree for people: short lists and objects on one line, at most 100 columns.
std::string pretty_json(const Json& json, int indent = 0);

}  // namespace tp
