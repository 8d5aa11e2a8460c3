// Objects of the document: a shape, where it is, what it is made of.
#pragma once

#include <teapath/core/math.h>
#include <teapath/scene/ids.h>
#include <teapath/scene/mesh.h>
#include <teapath/scene/transform.h>

#include <string>
#include <variant>

namespace tp {

// Texture coordinates: u to the right, v downwards, (0, 0) at the top left of an image, so that an
// image stands upright on each shape seen from its front.

/// u runs eastwards with (atan2(-z, x) + pi) / 2 pi, v = acos(y) / pi of the unit direction.
struct SphereShape {
    Double3 center{0, 0, 0};
    double radius = 1;  // negative: the normal points inwards
    friend bool operator==(const SphereShape&, const SphereShape&) = default;
};

/// Rectangles across an axis, front towards its positive end. XY: a = x, b = y, k = z;
/// XZ: a = x, b = z, k = y; YZ: a = y, b = z, k = x.
struct XyRectShape {
    Double2 low{-0.5, -0.5}, high{0.5, 0.5};
    double k = 0;
    friend bool operator==(const XyRectShape&, const XyRectShape&) = default;
};
struct XzRectShape {
    Double2 low{-0.5, -0.5}, high{0.5, 0.5};
    double k = 0;
    friend bool operator==(const XzRectShape&, const XzRectShape&) = default;
};
struct YzRectShape {
    Double2 low{-0.5, -0.5}, high{0.5, 0.5};
    double k = 0;
    friend bool operator==(const YzRectShape&, const YzRectShape&) = default;
};

/// A parallelogram: normal edge_u x edge_v, uv = (0, 0) at the corner and 1 along each edge.
struct RectangleShape {
    Double3 corner{-0.5, 0, 0.5};
    Double3 edge_u{1, 0, 0};
    Double3 edge_v{0, 0, -1};
    friend bool operator==(const RectangleShape&, const RectangleShape&) = default;
};

/// Normals outwards; each face has the whole unit square of uv, upright seen from outside.
struct BoxShape {
    Double3 low{-0.5, -0.5, -0.5}, high{0.5, 0.5, 0.5};
    friend bool operator==(const BoxShape&, const BoxShape&) = default;
};

/// u is the angle, v the distance from the centre (0) to the rim (1).
struct DiskShape {
    Double3 center{0, 0, 0};
    Double3 normal{0, 1, 0};
    double radius = 1;
    friend bool operator==(const DiskShape&, const DiskShape&) = default;
};

/// Counter-clockwise is front; uv are the barycentric weights of b and c.
struct TriangleShape {
    Double3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
    friend bool operator==(const TriangleShape&, const TriangleShape&) = default;
};

/// Triangles of a file. `placement` comes before the object's transform: what a model file does
/// to the mesh and a Transform cannot say (shear).
struct MeshShape {
    MeshFile file;
    bool smooth = true;  // shade by the mesh's normals, where it has any
    DoubleMat3 placement{1};
    friend bool operator==(const MeshShape&, const MeshShape&) = default;
};

using Shape = std::variant<SphereShape, XyRectShape, XzRectShape, YzRectShape, RectangleShape,
                           BoxShape, DiskShape, TriangleShape, MeshShape>;

struct Object {
    ObjectId id;
    std::string name;
    Shape shape;
    Transform transform;
    MaterialId material;
    bool inside_out = false;  // turns the normal round
    bool visible = true;
    bool camera_visible = true;      // to rays of the camera
    bool casts_shadows = true;       // on what lights shine at
    bool reflection_visible = true;  // to rays that were scattered
    ModelPart part;

    friend bool operator==(const Object&, const Object&) = default;
};

}  // namespace tp
