// From the document's camera to the kernels' record.
#pragma once

#include <teapath/kernel/records.h>
#include <teapath/scene/scene.h>

namespace tp {

/// The active camera of a scene.
CameraRecord flatten_camera(const Scene& scene);

}  // namespace tp
