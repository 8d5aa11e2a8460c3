// Numbers as a user reads and types them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// At most `digits` significant digits (whole numbers keep all of theirs up to a million), zeros at
/// the end only up to `decimals` places: 0.5 with 2 places is "0.50", 123.456 is "123.5".
std::string short_number(double value, int decimals, int digits = 4);

/// The shortest text that reads back as the same number; as a float where `single`.
std::string exact_number(double value, bool single = false);

/// Expressions with commas, semicolons or spaces between them: "1, 2*pi, 3", "0.1 0.2 0.3"; empty
/// if one of them is none. Spaces separate only where commas and semicolons do not.
std::vector<double> numbers_of(std::string_view text);

/// "#rrggbb" of sRGB values in [0, 1], and back; empty for anything else.
std::string hex_of(const std::vector<float>& srgb);
std::vector<float> srgb_of_hex(std::string_view text);

}  // namespace tp
