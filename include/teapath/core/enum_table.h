// One table per enum: value, name in files and on the command line, label for people. JSON,
// command line, menus and tests all read the same table.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace tp {

template <class Enum>
struct EnumRow {
    Enum value;
    std::string_view name;   // snake_case, as in files
    std::string_view label;  // a few words, as in menus
};

/// Specialise for each enum: `static constexpr std::array rows = {EnumRow<E>{…}, …};`
template <class Enum>
struct EnumTable;

/// The name in files; "?" for a value that no row has.
template <class Enum>
constexpr std::string_view enum_name(Enum value) {
    for (const auto& row : EnumTable<Enum>::rows)
        if (row.value == value) return row.name;
    return "?";
}

/// The value of a name, or nothing.
template <class Enum>
constexpr std::optional<Enum> enum_value(std::string_view name) {
    for (const auto& row : EnumTable<Enum>::rows)
        if (row.name == name) return row.value;
    return std::nullopt;
}

/// All names, as "a, b, c", for messages.
template <class Enum>
std::string enum_names() {
    std::string names;
    for (const auto& row : EnumTable<Enum>::rows) {
        if (!names.empty()) names += ", ";
        names += row.name;
    }
    return names;
}

}  // namespace tp
