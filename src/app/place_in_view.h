// Where a new object goes: in front of the camera, on what is seen there.
#pragma once

#include <teapath/scene/scene.h>

namespace tp {

struct Place {
    Double3 point{0, 0, 0};
    bool is_surface = false;  // something is there to stand on; else it hangs in the air
    double distance = 1;      // of the point from the camera
};

/// The point in the middle of the view: on the nearest surface if it is not much farther than what
/// is looked at, else the point looked at. Scenes of very many objects are not traced for it.
Place place_in_view(const Scene& scene);

}  // namespace tp
