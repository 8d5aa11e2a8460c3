#include "mesh_finish.h"
#include "mesh_readers.h"
#include "polygon.h"
#include "text_scanner.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <utility>

namespace tp {
namespace {

constexpr size_t kHeaderBytes = 84, kTriangleBytes = 50;

// Gives the same number to corners at the same place: a hash table with open addressing.
class Welder {
public:
    explicit Welder(std::vector<Float3>& positions) : positions_(positions) { grow(1024); }

    uint32_t vertex_at(Float3 p) {
        p += Float3(0);  // -0 becomes 0
        if (2 * positions_.size() >= slots_.size()) grow(2 * slots_.size());
        size_t slot = slot_of(p);
        while (slots_[slot] != kEmpty) {
            if (positions_[slots_[slot]] == p) return slots_[slot];
            slot = (slot + 1) & (slots_.size() - 1);
        }
        slots_[slot] = static_cast<uint32_t>(positions_.size());
        positions_.push_back(p);
        return slots_[slot];
    }

private:
    static constexpr uint32_t kEmpty = ~uint32_t{0};

    size_t slot_of(Float3 p) const {
        uint64_t hash = 0;
        for (int i = 0; i < 3; ++i)
            hash = (hash ^ std::bit_cast<uint32_t>(p[i])) * 0x9e3779b97f4a7c15u;
        return static_cast<size_t>(hash >> shift_);
    }

    void grow(size_t size) {
        slots_.assign(size, kEmpty);
        shift_ = 64 - std::countr_zero(size);
        for (size_t i = 0; i < positions_.size(); ++i) {
            size_t slot = slot_of(positions_[i]);
            while (slots_[slot] != kEmpty)
                slot = (slot + 1) & (size - 1);
            slots_[slot] = static_cast<uint32_t>(i);
        }
    }

    std::vector<Float3>& positions_;
    std::vector<uint32_t> slots_;  // a power of two of them, at most half full
    int shift_ = 0;
};

uint32_t count_in_header(std::string_view bytes) {
    uint32_t count = 0;
    for (size_t i = 0; i < 4; ++i)
        count |= uint32_t{static_cast<uint8_t>(bytes[80 + i])} << 8 * i;
    return count;
}

// Binary files may start with "solid" too; then the size, or a byte that no text has, tells.
bool is_binary(std::string_view bytes) {
    if (bytes.size() >= kHeaderBytes &&
        bytes.size() == kHeaderBytes + kTriangleBytes * uint64_t{count_in_header(bytes)})
        return true;
    const size_t start = bytes.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos || bytes.compare(start, 5, "solid") != 0) return true;
    return bytes.substr(0, 512).find('\0') != std::string_view::npos;
}

float little_float(const char* at) {
    uint32_t bits = 0;
    for (size_t i = 0; i < 4; ++i)
        bits |= uint32_t{static_cast<uint8_t>(at[i])} << 8 * i;
    return std::bit_cast<float>(bits);
}

Mesh read_binary(std::string_view bytes, const std::string& name) {
    if (bytes.size() < kHeaderBytes)
        throw Error(ErrorKind::Input, "this is not an STL file", name, "export the mesh again");
    const uint32_t count = count_in_header(bytes);
    if ((bytes.size() - kHeaderBytes) / kTriangleBytes < count)
        throw Error(
            ErrorKind::Input,
            fmt::format("the header promises {} triangles, which the file is too short for", count),
            name, "the file may be cut short: copy or export it again");
    Mesh mesh;
    mesh.triangles.resize(count);
    mesh.positions.reserve(count / 2 + 2);
    Welder welder(mesh.positions);
    for (uint32_t i = 0; i < count; ++i) {
        const char* at = bytes.data() + kHeaderBytes + kTriangleBytes * i + 12;
        for (size_t corner = 0; corner < 3; ++corner, at += 12)
            mesh.triangles[i][corner] =
                welder.vertex_at({little_float(at), little_float(at + 4), little_float(at + 8)});
    }
    return mesh;
}

Mesh read_text(std::string_view bytes, const std::string& name) {
    Mesh mesh;
    Welder welder(mesh.positions);
    PolygonCutter cutter;
    std::vector<uint32_t> corners;
    std::vector<Float3> places;
    TextScanner text(bytes);
    uint64_t facet = 0;
    const auto fail = [&](const std::string& what) {
        throw Error(ErrorKind::Input, what, fmt::format("{}: facet {}", name, facet),
                    "export the mesh again");
    };
    bool is_closed = true;
    for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
        if (word == "solid" || word == "endsolid") {
            text.skip_line();  // a name may be any words
        } else if (word == "vertex") {
            Float3 p;
            for (int i = 0; i < 3; ++i) {
                const std::optional<double> value = text.number();
                if (!value) fail("a vertex needs three numbers");
                p[i] = static_cast<float>(value.value_or(0));
            }
            corners.push_back(welder.vertex_at(p));
            places.push_back(p);
            is_closed = false;
        } else if (word == "endloop" || word == "endfacet") {
            if (!corners.empty() && corners.size() < 3) fail("it has fewer than three vertices");
            cutter.cut(places.data(), corners.data(), corners.size(), mesh.triangles);
            corners.clear();
            places.clear();
            is_closed = true;
            facet += word == "endfacet";
        }
    }
    if (!is_closed) fail("the file ends too early");
    return mesh;
}

}  // namespace

Mesh read_stl(std::string_view bytes, const std::string& name) {
    return finish_mesh(is_binary(bytes) ? read_binary(bytes, name) : read_text(bytes, name), name);
}

}  // namespace tp
