#include "data_uri.h"

#include <teapath/core/error.h>

#include <array>
#include <cstdint>

namespace tp {
namespace {

constexpr uint8_t kNoDigit = 255;

constexpr std::array<uint8_t, 256> base64_digits() {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<uint8_t, 256> values{};
    for (uint8_t& value : values)
        value = kNoDigit;
    for (size_t i = 0; i < digits.size(); ++i)
        values[static_cast<uint8_t>(digits[i])] = static_cast<uint8_t>(i);
    return values;
}

constexpr std::array<uint8_t, 256> kDigits = base64_digits();

[[noreturn]] void fail(const char* what, const std::string& where) {
    throw Error(ErrorKind::Input, what, where, "export the model again");
}

std::string decode_base64(std::string_view text, const std::string& where) {
    while (!text.empty() && text.back() == '=')
        text.remove_suffix(1);
    if (text.size() % 4 == 1) fail("the base64 data is cut short", where);
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const uint8_t digit = kDigits[static_cast<uint8_t>(c)];
        if (digit == kNoDigit) fail("the data is not base64", where);
        bits = bits << 6 | digit;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 255);
    }
    return bytes;
}

int hexadecimal(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

}  // namespace

bool is_data_uri(std::string_view uri) {
    return uri.starts_with("data:");
}

DataUri decode_data_uri(std::string_view uri, const std::string& where) {
    const size_t comma = uri.find(',');
    if (!is_data_uri(uri) || comma == std::string_view::npos)
        fail("the data URI has no comma", where);
    const std::string_view head = uri.substr(5, comma - 5);
    if (!head.ends_with(";base64")) fail("the data URI is not in base64", where);
    return {std::string(head.substr(0, head.find(';'))),
            decode_base64(uri.substr(comma + 1), where)};
}

std::string percent_decoded(std::string_view uri) {
    std::string text;
    for (size_t i = 0; i < uri.size(); ++i) {
        const int high = uri[i] == '%' && i + 2 < uri.size() ? hexadecimal(uri[i + 1]) : -1;
        const int low = high >= 0 ? hexadecimal(uri[i + 2]) : -1;
        if (low >= 0) {
            text += static_cast<char>(high * 16 + low);
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

}  // namespace tp
