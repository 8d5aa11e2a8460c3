// The rows of a PLY file, one value after the other, in each of the three formats.
#pragma once

#include "ply_header.h"
#include "text_scanner.h"

#include <bit>
#include <concepts>
#include <cstring>

namespace tp {

/// A number of the file's byte order.
template <class T>
T load_ply(const char* at, bool swap) {
    char bytes[sizeof(T)];
    if (swap)
        for (size_t i = 0; i < sizeof(T); ++i)
            bytes[i] = at[sizeof(T) - 1 - i];
    else
        std::memcpy(bytes, at, sizeof(T));
    return std::bit_cast<T>(bytes);
}

/// Calls `f` with a null value of the C++ type.
template <class F>
decltype(auto) with_ply_type(PlyType type, F&& f) {
    switch (type) {
        case PlyType::I8: return f(int8_t{});
        case PlyType::U8: return f(uint8_t{});
        case PlyType::I16: return f(int16_t{});
        case PlyType::U16: return f(uint16_t{});
        case PlyType::I32: return f(int32_t{});
        case PlyType::U32: return f(uint32_t{});
        case PlyType::F32: return f(float{});
        case PlyType::F64: break;
    }
    return f(double{});
}

/// Walks through the body. Throws Error(Input) where it ends too early, or a word is no number.
class PlyBody {
public:
    PlyBody(std::string_view bytes, const PlyHeader& header, const std::string& name);

    bool is_ascii() const { return format_ == PlyFormat::Ascii; }
    bool swaps() const { return swap_; }

    /// The next value; Value is double or int64_t. A fraction, NaN or what is out of range of an
    /// int64_t becomes -1.
    template <class Value>
    Value next(PlyType type);

    /// The next length of a list, checked against the bytes that are left.
    uint64_t next_length(const PlyProperty& list);

    void skip_values(PlyType type, uint64_t count);
    void skip_row(const PlyElement& element);

    /// The rows of a binary element without lists, all there; the body then stands behind them.
    const char* take_rows(const PlyElement& element);

    /// Begins an element: its name is said in messages. Throws if the bytes that are left could not
    /// hold its rows, so that its count can be trusted.
    void begin(const PlyElement& element);
    void set_row(uint64_t row) { row_ = row; }
    [[noreturn]] void fail(const std::string& what) const;

private:
    [[noreturn]] void fail_at_end() const;
    double next_word();

    PlyFormat format_;
    bool swap_;
    const char* at_;
    const char* end_;
    TextScanner text_;
    size_t text_bytes_;
    const std::string& name_;
    std::string element_;
    uint64_t row_ = 0;
};

template <class Value>
Value PlyBody::next(PlyType type) {
    const auto converted = [](auto value) -> Value {
        if constexpr (std::same_as<Value, int64_t> && std::floating_point<decltype(value)>) {
            const auto wide = static_cast<double>(value);
            const bool whole = wide > -9e15 && wide < 9e15 &&
                               static_cast<double>(static_cast<int64_t>(wide)) == wide;
            return whole ? static_cast<int64_t>(wide) : -1;
        } else {
            return static_cast<Value>(value);
        }
    };
    if (is_ascii()) return converted(next_word());
    return with_ply_type(type, [&](auto zero) {
        using T = decltype(zero);
        if (static_cast<size_t>(end_ - at_) < sizeof(T)) fail_at_end();
        const T value = load_ply<T>(at_, swap_);
        at_ += sizeof(T);
        return converted(value);
    });
}

}  // namespace tp
