// The outline of an object in the picture, exact: every shape so far is convex, so its outline is
// that of its projected corners, and for round ones that of the circle where rays graze it. What
// hides the object is not asked; what lies behind the camera is cut off. Pure functions.
#pragma once

#include <teapath/scene/camera.h>
#include <teapath/scene/object.h>

#include <vector>

namespace tp {

/// The outline in [0, 1]^2 of the picture, (0, 0) at its top left, as a convex polygon, cut to a
/// frame somewhat larger than the picture. Empty where the object is out of view, or where the
/// camera is inside it. Round outlines have as many corners as keep them within a quarter of a
/// pixel for a picture `height` pixels high.
std::vector<Double2> outline_of(const Object& object, const Camera& camera, double aspect,
                                double height);

}  // namespace tp
