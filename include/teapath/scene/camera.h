// A camera of the document.
#pragma once

#include <teapath/core/math.h>
#include <teapath/kernel/kinds.h>
#include <teapath/scene/ids.h>

#include <string>

namespace tp {

struct Camera {
    CameraId id;
    std::string name;
    Double3 look_from{0, 1, 4};
    Double3 look_at{0, 0, 0};
    Double3 up{0, 1, 0};  // need not be perpendicular to the view; not parallel to it
    ProjectionKind projection = ProjectionKind::Perspective;
    double vertical_fov = 40;   // degrees over the full height of the film, above 0; Perspective:
                                // below 180, Fisheye: up to 360
    double film_height = 4;     // Orthographic: scene units
    Double2 shift{0, 0};        // of the film to the right and up, in its width and height
    double aperture = 0;        // diameter of the lens in scene units; 0 = pinhole
    int blades = 0;             // of the aperture, 3 to 32; 0 = round
    double blade_rotation = 0;  // degrees counter-clockwise from a corner at the top
    double focus_distance = 0;  // of the sharp plane along the view axis; 0 = at look_at
    double near_clip = 0;       // distance along the view axis; 0 = off
    double far_clip = 0;        // distance along the view axis; 0 = off

    friend bool operator==(const Camera&, const Camera&) = default;
};

}  // namespace tp
