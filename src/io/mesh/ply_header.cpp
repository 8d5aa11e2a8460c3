#include "ply_header.h"

#include "text_scanner.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace tp {
namespace {

constexpr size_t kMaxElements = 1000, kMaxProperties = 1000;

std::optional<PlyType> type_of(std::string_view word) {
    constexpr std::pair<std::string_view, PlyType> kTypes[] = {
        {"char", PlyType::I8},    {"int8", PlyType::I8},     {"uchar", PlyType::U8},
        {"uint8", PlyType::U8},   {"short", PlyType::I16},   {"int16", PlyType::I16},
        {"ushort", PlyType::U16}, {"uint16", PlyType::U16},  {"int", PlyType::I32},
        {"int32", PlyType::I32},  {"uint", PlyType::U32},    {"uint32", PlyType::U32},
        {"float", PlyType::F32},  {"float32", PlyType::F32}, {"double", PlyType::F64},
        {"float64", PlyType::F64}};
    for (const auto& [name, type] : kTypes)
        if (name == word) return type;
    return {};
}

class HeaderParser {
public:
    HeaderParser(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    PlyHeader parse() {
        std::string_view line;
        if (!next_line(line) || line != "ply") fail("this is not a PLY file");
        bool has_format = false;
        while (next_line(line)) {
            TextScanner words(line);
            const std::string_view keyword = words.word();
            if (keyword == "end_header") {
                if (!has_format) fail("the header does not name the format");
                header_.size = at_;
                return std::move(header_);
            }
            if (keyword == "format") {
                has_format = true;
                read_format(words.word());
            } else if (keyword == "element") {
                read_element(words);
            } else if (keyword == "property") {
                read_property(words);
            } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
                fail(fmt::format("\"{}\" is no word of a header", keyword.substr(0, 40)));
            }
        }
        fail("the header has no end");
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Error(ErrorKind::Input, what, fmt::format("{}: line {}", name_, line_),
                    "export the mesh again");
    }

    // A line without its end, which is \n, \r\n or \r.
    bool next_line(std::string_view& line) {
        const size_t stop = bytes_.find_first_of("\r\n", at_);
        ++line_;
        if (stop == std::string_view::npos) return false;
        line = bytes_.substr(at_, stop - at_);
        at_ = stop + 1;
        if (bytes_[stop] == '\r' && at_ < bytes_.size() && bytes_[at_] == '\n') ++at_;
        return true;
    }

    void read_format(std::string_view word) {
        if (word == "ascii")
            header_.format = PlyFormat::Ascii;
        else if (word == "binary_little_endian")
            header_.format = PlyFormat::Little;
        else if (word == "binary_big_endian")
            header_.format = PlyFormat::Big;
        else
            fail(fmt::format("\"{}\" is no format of PLY", word.substr(0, 40)));
    }

    void read_element(TextScanner& words) {
        PlyElement element;
        element.name = words.word();
        const std::string_view count = words.word();
        const auto [stop, error] =
            std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (element.name.empty() || error != std::errc() || stop != count.data() + count.size())
            fail("an element needs a name and a count");
        if (header_.elements.size() == kMaxElements) fail("there are too many elements");
        header_.elements.push_back(std::move(element));
    }

    void read_property(TextScanner& words) {
        if (header_.elements.empty()) fail("a property stands before the first element");
        PlyElement& element = header_.elements.back();
        PlyProperty property;
        std::string_view type = words.word();
        if (type == "list") {
            property.is_list = element.has_lists = true;
            property.count_type = known_type(words.word());
            if (property.count_type == PlyType::F32 || property.count_type == PlyType::F64)
                fail("the length of a list must be a whole number");
            type = words.word();
        }
        property.type = known_type(type);
        property.name = words.word();
        property.offset = element.row_bytes;
        if (property.name.empty()) fail("a property has no name");
        if (element.properties.size() == kMaxProperties) fail("there are too many properties");
        element.row_bytes += size_of(property.is_list ? property.count_type : property.type);
        element.properties.push_back(std::move(property));
    }

    PlyType known_type(std::string_view word) const {
        const std::optional<PlyType> type = type_of(word);
        if (!type) fail(fmt::format("\"{}\" is no type of PLY", word.substr(0, 40)));
        return *type;
    }

    std::string_view bytes_;
    const std::string& name_;
    PlyHeader header_;
    size_t at_ = 0;
    size_t line_ = 0;
};

}  // namespace

const PlyProperty* PlyElement::find(std::string_view property) const {
    for (const PlyProperty& p : properties)
        if (p.name == property) return &p;
    return nullptr;
}

PlyHeader parse_ply_header(std::string_view bytes, const std::string& name) {
    return HeaderParser(bytes, name).parse();
}

}  // namespace tp
