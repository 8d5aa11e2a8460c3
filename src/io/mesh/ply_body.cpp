#include "ply_body.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

namespace tp {

PlyBody::PlyBody(std::string_view bytes, const PlyHeader& header, const std::string& name)
    : format_(header.format),
      swap_((header.format == PlyFormat::Big) == (std::endian::native == std::endian::little)),
      at_(bytes.data() + header.size),
      end_(bytes.data() + bytes.size()),
      text_(bytes.substr(header.size)),
      text_bytes_(bytes.size() - header.size),
      name_(name) {}

void PlyBody::fail(const std::string& what) const {
    throw Error(ErrorKind::Input, what, fmt::format("{}: {} {}", name_, element_, row_),
                "export the mesh again");
}

void PlyBody::fail_at_end() const {
    fail("the file ends too early");
}

void PlyBody::begin(const PlyElement& element) {
    element_ = element.name;
    row_ = 0;
    // A value of a text has a digit and a space.
    const uint64_t left = is_ascii() ? (text_bytes_ + 1) / 2 : static_cast<uint64_t>(end_ - at_);
    const uint64_t row = is_ascii() ? element.properties.size() : element.row_bytes;
    if (row > 0 && element.count > left / row)
        throw Error(ErrorKind::Input,
                    fmt::format("the header promises {} rows of \"{}\", which the file is too "
                                "short for",
                                element.count, element.name),
                    name_, "the file may be cut short: copy or export it again");
}

double PlyBody::next_word() {
    const std::optional<double> value = text_.number();
    if (value) return *value;
    const std::string_view word = text_.word();
    if (word.empty()) fail_at_end();
    fail(fmt::format("\"{}\" is no number", word.substr(0, 40)));
}

uint64_t PlyBody::next_length(const PlyProperty& list) {
    const auto length = next<int64_t>(list.count_type);
    if (length < 0) fail("the length of a list is negative");
    const auto left = static_cast<uint64_t>(
        is_ascii() ? (text_bytes_ + 1) / 2 : static_cast<size_t>(end_ - at_) / size_of(list.type));
    if (static_cast<uint64_t>(length) > left)
        fail(fmt::format("a list of {} values is longer than the rest of the file", length));
    return static_cast<uint64_t>(length);
}

void PlyBody::skip_values(PlyType type, uint64_t count) {
    if (is_ascii()) {
        for (uint64_t i = 0; i < count; ++i)
            next_word();
        return;
    }
    if (count > static_cast<uint64_t>(end_ - at_) / size_of(type)) fail_at_end();
    at_ += count * size_of(type);
}

void PlyBody::skip_row(const PlyElement& element) {
    for (const PlyProperty& property : element.properties)
        skip_values(property.type, property.is_list ? next_length(property) : 1);
}

const char* PlyBody::take_rows(const PlyElement& element) {
    const char* rows = at_;
    at_ += element.count * element.row_bytes;  // begin() has seen that they are there
    return rows;
}

}  // namespace tp
