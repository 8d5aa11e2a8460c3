// Procedural content of a scene: the file keeps the recipe, `expand` makes the objects.
#pragma once

#include <teapath/core/math.h>
#include <teapath/scene/ids.h>

#include <string>
#include <vector>

namespace tp {

/// The random grid of spheres of Ray Tracing in One Weekend, with its sizes open: `columns` along
/// x, `rows` along z, one sphere a cell, standing on the plane y = `ground`. Each cell has random
/// numbers of its own (TEA keyed by the seed), so that leaving one out changes no other.
struct SphereGrid {
    int columns = 22;
    int rows = 22;
    double spacing = 1;    // scene units between cells; the grid is centred on `center`
    Double2 center{0, 0};  // x, z
    double ground = 0;     // y of the plane that the spheres stand on
    double radius = 0.2;
    double jitter = 0.9;      // sphere centre = cell corner + jitter * u * spacing, u in [0, 1)^2
    double lambertian = 0.8;  // probabilities; the rest is glass of index `ior`
    double metal = 0.15;
    double ior = 1.5;
    bool thesis_colors = false;  // colours by the thesis' text instead of the book's rule
    // Spheres (x, y, z, r): what would have its centre within one is left out.
    std::vector<Double4> keep_clear;
    uint64_t seed = 0;

    friend bool operator==(const SphereGrid&, const SphereGrid&) = default;
};

/// The box that holds the centres of the grid's spheres, whatever its seed.
struct GridBox {
    Double3 low, high;
};
GridBox box_of_centers(const SphereGrid& grid);

struct Generator {
    GeneratorId id;
    std::string name;
    SphereGrid grid;  // the only kind so far

    friend bool operator==(const Generator&, const Generator&) = default;
};

}  // namespace tp
