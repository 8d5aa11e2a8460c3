// Typed, stable names of the things in a scene: an id never changes while the thing lives and is
// not a position in a vector.
#pragma once

#include <compare>
#include <cstdint>

namespace tp {

/// An id of one kind of thing; 0 means none.
template <class Tag>
struct Id {
    uint32_t value = 0;

    explicit operator bool() const { return value != 0; }
    friend auto operator<=>(const Id&, const Id&) = default;
};

using ObjectId = Id<struct ObjectTag>;
using MaterialId = Id<struct MaterialTag>;
using TextureId = Id<struct TextureTag>;
using CameraId = Id<struct CameraTag>;
using GeneratorId = Id<struct GeneratorTag>;

}  // namespace tp
