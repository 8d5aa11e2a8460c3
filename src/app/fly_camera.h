// Moving a camera of the document as one flies: pure functions of the camera, keys and time.
#pragma once

#include <teapath/scene/camera.h>

namespace tp {

struct FlyInput {
    double right = 0, up = 0, forward = 0;  // -1 to 1: keys
    double yaw = 0, pitch = 0;              // degrees to the right and up: mouse
    double speed = 1;                       // scene units a second
    double seconds = 0;                     // since the last frame
};

/// The camera after the input: it turns about itself and moves along its own axes (up: the
/// world's), and looks as far as before.
Camera fly(const Camera& camera, const FlyInput& input);

/// The camera turned about `pivot` by degrees, as orbiting does.
Camera orbit(const Camera& camera, const Double3& pivot, double yaw, double pitch);

/// The camera moved so that a sphere fills the view, from where it looks now.
Camera frame(const Camera& camera, const Double3& center, double radius);

}  // namespace tp
