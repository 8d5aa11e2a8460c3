// A host copy of the film: what a render holds so far, as means over its samples.
#pragma once

#include <cstdint>
#include <vector>

namespace tp {

/// Row-major, top row first, channels interleaved. The feature planes (alpha to material_id) are
/// empty unless they were asked for.
struct FilmImage {
    int width = 0;
    int height = 0;
    int64_t samples = 0;                // per pixel
    std::vector<float> radiance;        // RGB, linear
    std::vector<float> standard_error;  // of the mean's luminance
    std::vector<float> alpha;           // share of samples whose camera ray hit something
    std::vector<float> albedo;          // RGB at the first hit, background's colour elsewhere
    std::vector<float> normal;          // XYZ, world space, towards the camera, at the first hit
    std::vector<float> depth;         // distance along the view axis, mean over hits; 0 where none
    std::vector<uint32_t> object_id;  // ObjectId::value at the pixel's centre; 0 = none
    std::vector<uint32_t> material_id;  // MaterialId::value at the pixel's centre; 0 = none
};

}  // namespace tp
