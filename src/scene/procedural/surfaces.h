// Surfaces as grids of a function of two parameters: revolved profiles, tubes along curves.
#pragma once

#include <teapath/scene/mesh.h>

#include <functional>
#include <vector>

namespace tp {

/// A place for (u, v) in [0, 1]^2.
using SurfaceFunction = std::function<Double3(double u, double v)>;
using CurveFunction = std::function<Double3(double t)>;

/// Adds columns x rows quads of the surface, with normals by its derivatives and (u, v) as texture
/// coordinates. The front is where d/du x d/dv points.
void add_surface(Mesh& mesh, int columns, int rows, const SurfaceFunction& surface);

/// A cubic Bezier spline: 3 n + 1 points, n pieces, t in [0, 1] over all of them.
Double3 bezier(const std::vector<Double3>& points, double t);

/// Turns a profile of (radius, height, 0) points, a Bezier spline from below to above, about y,
/// with its front outwards.
void add_revolution(Mesh& mesh, int around, int along, const std::vector<Double3>& profile);

/// A tube of `radius(t)` along a curve, round, without twist (Wang et al., "Computation of Rotation
/// Minimizing Frames", 2008). A `closed` curve meets its own beginning.
void add_tube(Mesh& mesh, int around, int along, const CurveFunction& curve,
              const std::function<double(double)>& radius, bool closed);

/// A disk that closes a tube's or a trunk's end; the front along `normal`.
void add_cap(Mesh& mesh, int around, Double3 center, Double3 normal, double radius);

}  // namespace tp
