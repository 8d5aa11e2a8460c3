// Moving a camera of the document as one flies: pure functions of the camera, keys and time. None
// of them makes a camera that a scene cannot hold, whatever it is given: where one would come of
// it, the camera stays as it is.
#pragma once

#include <teapath/scene/camera.h>

namespace tp {

struct FlyInput {
    double right = 0, up = 0, forward = 0;  // -1 to 1: keys
    double yaw = 0, pitch = 0;              // degrees to the right and up: mouse
    double speed = 1;                       // scene units a second
    double seconds = 0;                     // since the last frame
};

/// Unit vectors of what the camera sees: right x up points backwards.
struct CameraAxes {
    Double3 right, up, forward;
};
CameraAxes axes_of(const Camera& camera);

/// The camera after the input: it turns about itself and moves along its own axes (up: the
/// world's), and looks as far as before, or as far as it must to have a direction at all.
Camera fly(const Camera& camera, const FlyInput& input);

/// The camera turned about `pivot` by degrees, as orbiting does.
Camera orbit(const Camera& camera, const Double3& pivot, double yaw, double pitch);

/// The camera moved sideways so that a point at distance `depth` along the view axis follows a
/// pointer that moved by `pixels` (to the right and down) on a picture `height` pixels high.
Camera pan(const Camera& camera, const Double2& pixels, double height, double depth);

/// How much of the scene the height of the picture shows at that distance along the view axis, in
/// scene units; of panoramas that show more than 120 degrees, within those.
double seen_height(const Camera& camera, double distance);

/// The field of view changed by degrees, within 1 to 120, of a fisheye to 360; a value outside is
/// not pushed further. Orthographic: the film grows by 2 percent a degree. Equirectangular:
/// nothing.
Camera widened(const Camera& camera, double degrees);

/// The camera moved so that a sphere fills a view of this width over height, from where it looks
/// now.
Camera frame(const Camera& camera, const Double3& center, double radius, double aspect = 1);

}  // namespace tp
