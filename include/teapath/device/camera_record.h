// From a camera of the document to the kernels' record.
#pragma once

#include <teapath/kernel/records.h>
#include <teapath/scene/camera.h>

namespace tp {

/// For a film of this width over height.
CameraRecord camera_record(const Camera& camera, double aspect);

}  // namespace tp
