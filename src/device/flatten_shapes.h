// From a shape of the document to a hittable of the kernels.
#pragma once

#include <teapath/kernel/hittable.h>
#include <teapath/scene/object.h>

#include <optional>

namespace tp {

/// The hittable of an object in world space, without material and ids; nothing if it can never be
/// hit (radius 0, no area).
std::optional<Hittable> flatten_shape(const Object& object);

}  // namespace tp
