// What a scene contains, as bits: a kernel is compiled for some sets of them.
#pragma once

#include <cstdint>

namespace tp {

enum SceneFeature : uint32_t {
    kFeatureShapes = 1,        // hittables that are not spheres
    kFeatureTextures = 2,      // any texture, an image as background
    kFeatureLights = 4,        // emitting hittables
    kFeatureOpacity = 8,       // materials that let light straight through
    kFeatureSobol = 16,        // the Sobol sampler
    kFeatureDebug = 32,        // integrators other than Path and Book; brute force
    kFeatureMeshes = 64,       // hittables that are meshes
    kFeaturePrincipled = 128,  // materials of many lobes
    kFeatureHiding = 256,      // hittables that some rays pass through
    kFeatureProcedural = 512,  // textures beyond constants, checkers, images by uv; bump maps
    kFeatureAll = 1023
};

}  // namespace tp
