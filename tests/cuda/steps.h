// The calls that host and device make in the parity tests, written once.
#pragma once

#include "cuda/parity.h"

#include <teapath/kernel/path_steps.h>

namespace tp::test {

TP_HD StepOutput run_steps(const LaunchParams& params, const StepInput& input) {
    StepOutput out;
    out.hit = intersect<kFeatureAll>(params, input.path);
    const Sampler sampler = path_sampler(params, input.pixel, input.sample);
    out.path = input.path;
    out.goes_on = shade<kFeatureAll>(params, sampler, input.hit, out.path, out.shadow);
    if (out.shadow.is_active) out.light = transmittance<kFeatureAll>(params, out.shadow);
    return out;
}

TP_HD Vec3 run_path(const LaunchParams& params, uint32_t x, uint32_t y, uint32_t sample) {
    const Sampler sampler =
        path_sampler(params, y * static_cast<uint32_t>(params.width) + x, sample);
    PathState path = start_camera_path<kFeatureAll>(params, sampler, x, y);
    for (bool goes_on = true; goes_on;) {
        const Hit hit = intersect<kFeatureAll>(params, path);
        ShadowQuery shadow;
        goes_on = shade<kFeatureAll>(params, sampler, hit, path, shadow);
        connect_to_light<kFeatureAll>(params, shadow, path);
    }
    return path.radiance;
}

}  // namespace tp::test
