// The names of shapes in scene files, in the order of the variant Shape.
#pragma once

#include <teapath/scene/object.h>

#include <array>
#include <string>
#include <utility>

namespace tp {

inline constexpr std::array<const char*, 9> kShapeTypes = {
    "sphere", "xy_rect", "xz_rect", "yz_rect", "rectangle", "box", "disk", "triangle", "mesh"};
static_assert(kShapeTypes.size() == std::variant_size_v<Shape>);

/// Sets `shape` to a fresh one of that type; false for an unknown name.
inline bool make_shape(const std::string& type, Shape& shape) {
    const auto try_each = [&]<size_t... kIndex>(std::index_sequence<kIndex...>) {
        return ((type == kShapeTypes[kIndex] && (shape.emplace<kIndex>(), true)) || ...);
    };
    return try_each(std::make_index_sequence<kShapeTypes.size()>{});
}

inline std::string shape_type_names() {
    std::string names;
    for (const char* type : kShapeTypes)
        names += (names.empty() ? "" : ", ") + std::string(type);
    return names;
}

}  // namespace tp
