// Arithmetic in number fields.
#include <teapath/editor/expression.h>
#include <teapath/editor/number_text.h>

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

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

TEST_CASE("numbers: at most four digits are shown, all of them are edited") {
    CHECK(tp::short_number(0.5, 2) == "0.50");
    CHECK(tp::short_number(45, 1) == "45.0");
    CHECK(tp::short_number(123.456, 2) == "123.5");
    CHECK(tp::short_number(1234.56, 2) == "1235");
    CHECK(tp::short_number(0.012345, 0) == "0.01235");
    CHECK(tp::short_number(0, 2) == "0.00");
    CHECK(tp::short_number(-0.0, 2) == "0.00");
    CHECK(tp::short_number(3, 0) == "3");
    CHECK(tp::short_number(1.23456, 0, 2) == "1.2");
    CHECK(tp::short_number(1e9, 0) == "1e+09");
    CHECK(tp::short_number(1.5e-7, 2) == "1.5e-07");
    CHECK(tp::short_number(65536, 0) == "65536");
    for (const double x : {0.1, 1 / 3.0, 1e-12, 123456.789})
        CHECK(tp::numbers_of(tp::exact_number(x)) == std::vector{x});
    CHECK(tp::exact_number(static_cast<double>(0.3f), true) == "0.3");
}

TEST_CASE("numbers: lists and hex colours from the clipboard") {
    CHECK(tp::numbers_of("1, 2*3, max(1,2)") == std::vector<double>{1, 6, 2});
    CHECK(tp::numbers_of("0.1 0.2  0.3") == std::vector<double>{0.1, 0.2, 0.3});
    CHECK(tp::numbers_of("1; 2") == std::vector<double>{1, 2});
    CHECK(tp::numbers_of("1, two").empty());
    CHECK(tp::numbers_of("").empty());
    CHECK(tp::hex_of({1, 0, 0.5f}) == "#ff0080");
    CHECK(tp::srgb_of_hex("#ff0080").size() == 3);
    CHECK(tp::hex_of(tp::srgb_of_hex(" a1B2c3 ")) == "#a1b2c3");
    CHECK(tp::hex_of(tp::srgb_of_hex("#fa0")) == "#ffaa00");
    for (const char* text : {"", "#", "#12", "#12345g", "1234567"})
        CHECK(tp::srgb_of_hex(text).empty());
}
