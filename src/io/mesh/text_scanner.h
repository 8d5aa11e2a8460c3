// Words and numbers of a text in memory, for the ASCII forms of PLY and STL.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace tp {

class TextScanner {
public:
    explicit TextScanner(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {}

    /// The next word, without the space around it; empty at the end.
    std::string_view word() {
        skip_space();
        const char* start = at_;
        while (at_ != end_ && !is_space(*at_))
            ++at_;
        return {start, static_cast<size_t>(at_ - start)};
    }

    /// The next word as a number (infinities and NaN are numbers here); nothing if it is none.
    std::optional<double> number() {
        skip_space();
        if (at_ != end_ && *at_ == '+') ++at_;
        double value = 0;
        const auto [stop, error] = std::from_chars(at_, end_, value);
        if (error == std::errc::invalid_argument || (stop != end_ && !is_space(*stop))) return {};
        at_ = stop;
        return value;
    }

    /// The rest of the line; the scanner then stands on the next one.
    void skip_line() {
        while (at_ != end_ && *at_ != '\n' && *at_ != '\r')
            ++at_;
    }

private:
    static bool is_space(char c) {
        return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '\v' || c == '\f';
    }
    void skip_space() {
        while (at_ != end_ && is_space(*at_))
            ++at_;
    }

    const char* at_;
    const char* end_;
};

}  // namespace tp
