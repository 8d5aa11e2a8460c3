// Single steps on the device with inputs from the host, for tests of host against CUDA.
#pragma once

#include <teapath/device/scene_arrays.h>
#include <teapath/kernel/path_state.h>
#include <teapath/kernel/shapes/surface_point.h>

#include <cstdint>
#include <vector>

namespace tp::test {

/// A path before its next segment, and whose random numbers it takes.
struct StepInput {
    PathState path;
    uint32_t pixel = 0;
    uint32_t sample = 0;
    Hit hit;  // what the host found there
};

/// What the steps make of a StepInput.
struct StepOutput {
    Hit hit;              // step 2 on input.path
    PathState path;       // step 3 on input.path and input.hit
    ShadowQuery shadow;   // step 3
    Vec3 light{0, 0, 0};  // step 4 on `shadow`
    bool goes_on = false;
};

/// The steps of each input on the CUDA device, in the general variant.
std::vector<StepOutput> steps_on_device(const SceneArrays& arrays, int width, int height,
                                        const std::vector<StepInput>& inputs);

/// The radiance of one sample of each pixel on the device.
std::vector<Vec3> paths_on_device(const SceneArrays& arrays, int width, int height,
                                  uint32_t sample);

}  // namespace tp::test
