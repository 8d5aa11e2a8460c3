// The known name that a mistyped one was meant to be, for messages.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// Edits (insert, delete, replace, swap neighbours; letter case is free) that turn `a` into `b`.
int edit_distance(std::string_view a, std::string_view b);

/// The name closest to `wrong`, or "" where none is near enough to be what was meant. The first
/// one wins a draw.
std::string nearest_name(std::string_view wrong, std::span<const std::string> names);

}  // namespace tp
