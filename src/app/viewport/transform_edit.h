// What a gizmo does to the placement of objects: moving, turning and scaling about a pivot, in
// double precision and without taking matrices apart where that would lose something.
#pragma once

#include <teapath/scene/transform.h>

namespace tp {

/// The rotation of a transform as a matrix.
DoubleMat3 rotation_of(const Transform& t);

Transform moved(const Transform& t, const Double3& by);

/// Turned about `pivot` by a rotation of the world.
Transform turned_about(const Transform& t, const Double3& pivot, const DoubleMat3& rotation);

/// Scaled about `pivot` by `factor` along the axes that are the columns of `axes`. Where these are
/// not the object's own axes, shear cannot be kept: the object's axes are stretched as much as
/// the scaling stretches them. Equal factors are exact about any axes.
Transform scaled_about(const Transform& t, const Double3& pivot, const DoubleMat3& axes,
                       const Double3& factor);

}  // namespace tp
