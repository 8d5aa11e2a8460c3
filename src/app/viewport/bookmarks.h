// Views that a scene remembers: cameras named "bookmark 1" to "bookmark 9". Functions on the scene
// alone.
#pragma once

#include <teapath/scene/scene.h>

namespace tp {

/// The camera of a bookmark, or null.
const Camera* find_bookmark(const Scene& scene, int number);

/// Keeps the active camera's view as a bookmark, in place of the one with that number.
void set_bookmark(Scene& scene, int number);

/// Gives the active camera the view of a bookmark; it keeps its id and name. Nothing where the
/// bookmark is not set.
void go_to_bookmark(Scene& scene, int number);

}  // namespace tp
