#include <teapath/editor/expression.h>
#include <teapath/editor/number_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

// Takes zeros from the end, but leaves `decimals` places after the point.
void strip_zeros(std::string& text, int decimals) {
    const size_t point = text.find('.');
    if (point == std::string::npos) return;
    const size_t shortest = point + 1 + static_cast<size_t>(decimals);
    while (text.size() > shortest && text.back() == '0')
        text.pop_back();
    if (text.back() == '.') text.pop_back();
}

bool is_zero(const std::string& text) {
    return text.find_first_not_of("-0.") == std::string::npos;
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

}  // namespace

std::string short_number(double value, int decimals, int digits) {
    if (!std::isfinite(value)) return fmt::format("{}", value);
    const double size = std::abs(value);
    const int exponent = size > 0 ? static_cast<int>(std::floor(std::log10(size))) : 0;
    if (size > 0 && (exponent > 6 || exponent < -5)) return fmt::format("{:.{}g}", value, digits);
    const int places = std::max(0, digits - 1 - exponent);
    std::string text = fmt::format("{:.{}f}", value, std::max(places, 0));
    // A number that is too small for its places shows as what it is.
    strip_zeros(text, std::min(decimals, places));
    if (is_zero(text) && text[0] == '-') text.erase(0, 1);
    return text;
}

std::string exact_number(double value, bool single) {
    return single ? fmt::format("{}", static_cast<float>(value)) : fmt::format("{}", value);
}

std::vector<double> numbers_of(std::string_view text) {
    const bool has_marks = text.find_first_of(",;") != std::string_view::npos;
    const char* const separators = has_marks ? ",;" : " \t";
    std::vector<double> numbers;
    int brackets = 0;
    std::string part;
    const auto finish = [&] {
        const auto value = evaluate(part);
        part.clear();
        if (value) numbers.push_back(*value);
        return value.has_value();
    };
    for (const char c : text) {
        brackets += c == '(' ? 1 : c == ')' ? -1 : 0;
        const bool separates =
            brackets == 0 && std::string_view(separators).find(c) != std::string_view::npos;
        if (!separates)
            part += c;
        else if (has_marks || !part.empty())
            if (!finish()) return {};
    }
    if (!part.empty() && !finish()) return {};
    return numbers;
}

std::string hex_of(const std::vector<float>& srgb) {
    std::string text = "#";
    for (const float x : srgb)
        text += fmt::format("{:02x}", static_cast<int>(std::clamp(x, 0.0f, 1.0f) * 255 + 0.5f));
    return text;
}

std::vector<float> srgb_of_hex(std::string_view text) {
    while (!text.empty() && text.front() == ' ')
        text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ')
        text.remove_suffix(1);
    if (!text.empty() && text.front() == '#') text.remove_prefix(1);
    if (text.size() != 6 && text.size() != 3) return {};
    const size_t width = text.size() / 3;
    std::vector<float> srgb;
    for (size_t i = 0; i < 3; ++i) {
        const int high = hex_digit(text[i * width]), low = hex_digit(text[i * width + width - 1]);
        if (high < 0 || low < 0) return {};
        srgb.push_back(static_cast<float>(high * 16 + low) / 255.0f);
    }
    return srgb;
}

}  // namespace tp
