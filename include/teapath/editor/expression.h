// Arithmetic that a user types into a number field: "2*pi/3", "sqrt(2)/2", "x*1.5".
#pragma once

#include <optional>
#include <string_view>

namespace tp {

/// The value of an expression with + - * / % ^, brackets, pi, tau, e, and abs, ceil, cos, deg, exp,
/// floor, ln, log, max, min, pow, rad, round, sin, sqrt, tan (angles in radians). `x` is the value
/// that the field holds. Outside of brackets a comma between digits is a decimal point. Nothing if
/// the text is no such expression or its value is not finite.
std::optional<double> evaluate(std::string_view text, double x = 0);

}  // namespace tp
