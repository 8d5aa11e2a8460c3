// Typed, stable names of the things in a scene: an id never changes while the thing lives and is
// not a position in a vector.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

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
using ModelId = Id<struct ModelTag>;

/// Where a thing comes from: a part of a model file, or (no model) the scene file itself.
struct ModelPart {
    ModelId model;
    std::string path;  // "Car/Wheel.2": names of nodes, then the number of the primitive

    friend bool operator==(const ModelPart&, const ModelPart&) = default;
};

}  // namespace tp
