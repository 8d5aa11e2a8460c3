// Arithmetic in number fields.
#include <teapath/editor/expression.h>

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using tp::evaluate;

namespace {
double value_of(const char* text, double x = 0) {
    const auto value = evaluate(text, x);
    REQUIRE_MESSAGE(value.has_value(), text);
    return *value;
}
}  // namespace

TEST_CASE("expression: what people type into a number field") {
    const double pi = std::acos(-1.0);
    CHECK(value_of("2*pi/3") == doctest::Approx(2 * pi / 3));
    CHECK(value_of("1.5") == 1.5);
    CHECK(value_of(" .5 ") == 0.5);
    CHECK(value_of("1e-3") == 1e-3);
    CHECK(value_of("2.5E+2") == 250);
    CHECK(value_of("1+2*3") == 7);
    CHECK(value_of("(1+2)*3") == 9);
    CHECK(value_of("-2^2") == -4);
    CHECK(value_of("2^-1") == 0.5);
    CHECK(value_of("2^3^2") == 512);
    CHECK(value_of("7 % 4") == 3);
    CHECK(value_of("8/2/2") == 2);
    CHECK(value_of("5--3") == 8);
    CHECK(value_of("sqrt(2)/2") == doctest::Approx(std::sqrt(0.5)));
    CHECK(value_of("sin(pi/2)") == doctest::Approx(1));
    CHECK(value_of("rad(180)") == doctest::Approx(pi));
    CHECK(value_of("max(1, 2)") == 2);
    CHECK(value_of("min(1,2)") == 1);
    CHECK(value_of("2*e") == doctest::Approx(2 * std::exp(1.0)));
}

TEST_CASE("expression: x is the value before, a comma is a decimal point") {
    CHECK(value_of("x*2", 21) == 42);
    CHECK(value_of("x + 0,5", 1) == 1.5);
    CHECK(value_of("pow(2,0.5)") == doctest::Approx(std::sqrt(2)));
}

TEST_CASE("expression: what is no number is nothing") {
    for (const char* text :
         {"",     " ",     "abc",      "1/0",    "0/0", "sqrt(-1)", "1+",    "(1", "1)", "1 2",
          "1..2", "sin()", "sin(1,2)", "max(1)", "2x",  "1e999",    "pi pi", "--", "1,", "\n"})
        CHECK_MESSAGE(!evaluate(text).has_value(), text);
    CHECK(!evaluate(std::string(100000, '(')).has_value());
    CHECK(!evaluate(std::string(100000, '-') + "1").has_value());
}
