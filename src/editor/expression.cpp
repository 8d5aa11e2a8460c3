#include <teapath/editor/expression.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

namespace tp {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kMaxDepth = 64;  // of brackets and signs

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

double not_a_number() {
    return std::nan("");
}

// Functions of one and of two values; NaN for an unknown name.
double call(std::string_view name, double a) {
    if (name == "abs") return std::abs(a);
    if (name == "ceil") return std::ceil(a);
    if (name == "cos") return std::cos(a);
    if (name == "deg") return a * 180 / kPi;
    if (name == "exp") return std::exp(a);
    if (name == "floor") return std::floor(a);
    if (name == "ln" || name == "log") return std::log(a);
    if (name == "rad") return a * kPi / 180;
    if (name == "round") return std::round(a);
    if (name == "sin") return std::sin(a);
    if (name == "sqrt") return std::sqrt(a);
    if (name == "tan") return std::tan(a);
    return not_a_number();
}
double call(std::string_view name, double a, double b) {
    if (name == "max") return std::max(a, b);
    if (name == "min") return std::min(a, b);
    if (name == "pow") return std::pow(a, b);
    return not_a_number();
}

// Recursive descent; what is wrong makes the value NaN.
class Parser {
public:
    Parser(std::string_view text, double x) : text_(text), x_(x) {}

    double whole() {
        const double value = sum();
        skip_space();
        return at_ == text_.size() ? value : not_a_number();
    }

private:
    void skip_space() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t'))
            ++at_;
    }
    bool take(char c) {
        skip_space();
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }

    double sum() {
        double value = product();
        for (;;) {
            if (take('+'))
                value += product();
            else if (take('-'))
                value -= product();
            else
                return value;
        }
    }

    double product() {
        double value = signed_power();
        for (;;) {
            if (take('*'))
                value *= signed_power();
            else if (take('/'))
                value /= signed_power();
            else if (take('%'))
                value = std::fmod(value, signed_power());
            else
                return value;
        }
    }

    // -2^2 is -4, 2^-1 is 0.5, 2^3^2 is 2^9.
    double signed_power() {
        if (++depth_ > kMaxDepth) return not_a_number();
        double value = 0;
        if (take('-')) {
            value = -signed_power();
        } else if (take('+')) {
            value = signed_power();
        } else {
            value = operand();
            if (take('^')) value = std::pow(value, signed_power());
        }
        --depth_;
        return value;
    }

    double operand() {
        if (take('(')) {
            ++brackets_;
            const double value = sum();
            --brackets_;
            return take(')') ? value : not_a_number();
        }
        skip_space();
        if (at_ >= text_.size()) return not_a_number();
        if (is_letter(text_[at_])) return named();
        return number();
    }

    double named() {
        const size_t start = at_;
        while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_])))
            ++at_;
        const std::string_view name = text_.substr(start, at_ - start);
        if (!take('(')) {
            if (name == "pi") return kPi;
            if (name == "tau") return 2 * kPi;
            if (name == "e") return std::exp(1.0);
            return name == "x" ? x_ : not_a_number();
        }
        ++brackets_;
        const double first = sum();
        const bool has_second = take(',');
        const double second = has_second ? sum() : 0;
        --brackets_;
        if (!take(')')) return not_a_number();
        return has_second ? call(name, first, second) : call(name, first);
    }

    double number() {
        std::string digits;
        bool has_point = false;
        const auto next_is_digit = [&] {
            return at_ + 1 < text_.size() && is_digit(text_[at_ + 1]);
        };
        for (; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            const bool is_point = c == '.' || (c == ',' && brackets_ == 0 && next_is_digit());
            if (is_digit(c))
                digits += c;
            else if (is_point && !has_point)
                digits += '.', has_point = true;
            else
                break;
        }
        take_exponent(digits);
        double value = 0;
        const char* const end = digits.data() + digits.size();
        const auto [stop, error] = std::from_chars(digits.data(), end, value);
        return error == std::errc() && stop == end ? value : not_a_number();
    }

    // "e-3"; a mere "e" that no digits follow is not taken.
    void take_exponent(std::string& digits) {
        size_t end = at_;
        if (end >= text_.size() || (text_[end] != 'e' && text_[end] != 'E')) return;
        ++end;
        if (end < text_.size() && (text_[end] == '-' || text_[end] == '+')) ++end;
        if (end >= text_.size() || !is_digit(text_[end])) return;
        while (end < text_.size() && is_digit(text_[end]))
            ++end;
        std::string exponent(text_.substr(at_, end - at_));
        std::erase(exponent, '+');
        digits += exponent;
        at_ = end;
    }

    std::string_view text_;
    double x_;
    size_t at_ = 0;
    int depth_ = 0;
    int brackets_ = 0;
};

}  // namespace

std::optional<double> evaluate(std::string_view text, double x) {
    const double value = Parser(text, x).whole();
    if (!std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace tp
