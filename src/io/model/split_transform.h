// A matrix as the scene says it: a Transform, and what it cannot say.
#pragma once

#include <teapath/scene/transform.h>

#include <optional>

namespace tp {

struct SplitTransform {
    Transform transform;
    DoubleMat3 placement{1};  // shear, before the transform; identity where there is none
};

/// world_from_object = transform * placement (by Gram-Schmidt; a mirror becomes a negative scale
/// along x). Nothing if the matrix leaves no volume or is not finite.
std::optional<SplitTransform> split_transform(const DoubleMat4& world_from_object);

}  // namespace tp
