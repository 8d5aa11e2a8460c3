// Between the picture and the world, for every camera that a scene may have: rays through a point
// of the picture, and the way back for what is drawn over it. Pure functions.
#pragma once

#include <teapath/scene/camera.h>

namespace tp {

/// Through a point of the picture and the middle of the lens; `direction` is a unit vector.
struct ViewRay {
    Double3 origin, direction;  // the origin is on the near plane where there is one
    double t_max;               // to the far plane; 0 where the film shows nothing
};
/// (x, y) in [0, 1]^2, (0, 0) at the top left; the ray that the renderer traces.
ViewRay view_ray(const Camera& camera, double aspect, double x, double y);

/// False for panoramas: straight lines are curves on their film.
bool keeps_lines_straight(const Camera& camera);

/// The film of a camera that keeps lines straight: from its top left corner to the right and down.
/// Perspective: rays start at the camera and pass the film at distance 1; orthographic: they start
/// on it. In scene units, from the place of the camera.
struct FilmPlane {
    Double3 corner, right, down;
};
FilmPlane film_plane(const Camera& camera, double aspect);

/// From the world to clip space of a picture of this width over height, of a camera that keeps
/// lines straight: (-1, -1) is its lower left corner, z the distance along the view axis, w the
/// same in perspective, else 1.
DoubleMat4 clip_from_world(const Camera& camera, double aspect);

}  // namespace tp
