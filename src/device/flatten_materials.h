// From the document's materials and textures to the kernels' records.
#pragma once

#include <teapath/device/scene_arrays.h>

#include <unordered_map>

namespace tp {

/// Index of the record of each material; unknown ids get the default material, record 0.
using MaterialIndex = std::unordered_map<uint32_t, uint32_t>;
MaterialIndex index_materials(const Scene& scene);

/// Fills materials, material_ids, textures and texels of `arrays`, and the background.
void flatten_materials(const Scene& scene, SceneArrays& arrays);

}  // namespace tp
