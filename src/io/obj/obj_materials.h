// Materials of an MTL file as principled surfaces.
#pragma once

#include "mtl_library.h"
#include "obj_textures.h"

namespace tp {

/// The classic lines (Kd, Ks, Ns, Ke, d, Ni, illum and their maps) become what looks alike, those
/// of the PBR extension (Pr, Pm, Ps, Pc, Pcr, aniso) what they say. Ns is turned into roughness by
/// alpha = sqrt(2 / (Ns + 2)) (Walter et al. 2007). A bump map is taken for a normal map; the
/// caller takes it off again if it shows heights.
Material material_of(const MtlMaterial& source, ObjTextures& textures);

}  // namespace tp
