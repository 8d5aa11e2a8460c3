// One maker for each procedural mesh; each asks for its parameters.
#pragma once

#include "parameters.h"

#include <teapath/scene/mesh.h>

namespace tp {

// Vessels by revolved Bezier profiles (vessels.cpp).
Mesh make_teapot(ProceduralParameters& parameters);
Mesh make_bottle(ProceduralParameters& parameters);
Mesh make_wine_glass(ProceduralParameters& parameters);
Mesh make_bowl(ProceduralParameters& parameters);

// Solids (solids.cpp).
Mesh make_knot(ProceduralParameters& parameters);
Mesh make_torus(ProceduralParameters& parameters);
Mesh make_rounded_box(ProceduralParameters& parameters);
Mesh make_gem(ProceduralParameters& parameters);

// Of nature (terrain.cpp, tree.cpp, cloth.cpp).
Mesh make_terrain(ProceduralParameters& parameters);
Mesh make_tree(ProceduralParameters& parameters);
Mesh make_leaves(ProceduralParameters& parameters);
Mesh make_cloth(ProceduralParameters& parameters);

}  // namespace tp
