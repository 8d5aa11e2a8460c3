// The header of a PLY file: what elements follow, and of which properties each row consists.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

enum class PlyFormat : uint8_t { Ascii, Little, Big };
enum class PlyType : uint8_t { I8, U8, I16, U16, I32, U32, F32, F64 };

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::F32;
    bool is_list = false;
    PlyType count_type = PlyType::U8;  // of a list's length
    size_t offset = 0;                 // within a row, where no list stands before it
};

struct PlyElement {
    std::string name;
    uint64_t count = 0;
    std::vector<PlyProperty> properties;
    bool has_lists = false;
    size_t row_bytes = 0;  // in a binary file; with lists: the least

    /// The property of that name, or null.
    const PlyProperty* find(std::string_view property) const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    size_t size = 0;  // bytes before the body
};

inline size_t size_of(PlyType type) {
    constexpr size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<size_t>(type)];
}

/// Throws Error(Input) with the line of the mistake.
PlyHeader parse_ply_header(std::string_view bytes, const std::string& name);

}  // namespace tp
