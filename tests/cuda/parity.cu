#include "cuda/parity.h"
#include "cuda/steps.h"

#include <teapath/device/cuda_buffer.cuh>
#include <teapath/device/cuda_scene.cuh>
#include <teapath/device/cuda_stream.cuh>

namespace tp::test {
namespace {

__global__ void steps_kernel(const __grid_constant__ LaunchParams params, const StepInput* inputs,
                             StepOutput* outputs, uint32_t count) {
    const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < count) outputs[i] = run_steps(params, inputs[i]);
}

__global__ void paths_kernel(const __grid_constant__ LaunchParams params, uint32_t sample,
                             Vec3* radiance) {
    const uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
    const auto width = static_cast<uint32_t>(params.width);
    if (i < width * static_cast<uint32_t>(params.height))
        radiance[i] = run_path(params, i % width, i / width, sample);
}

LaunchParams params_of(const SceneArrays& arrays, const CudaScene& scene, int width, int height) {
    LaunchParams params;
    params.scene = scene.view();
    params.camera = arrays.camera;
    params.settings = arrays.settings;
    params.key = tea_key(0, arrays.settings.seed, arrays.settings.key_rounds);
    params.width = width;
    params.height = height;
    return params;
}

}  // namespace

std::vector<StepOutput> steps_on_device(const SceneArrays& arrays, int width, int height,
                                        const std::vector<StepInput>& inputs) {
    const Stream stream;
    CudaScene scene;
    scene.upload(arrays, SceneParts::All, stream);
    DeviceBuffer<StepInput> device_inputs;
    device_inputs.upload(inputs.data(), inputs.size(), stream.get());
    DeviceBuffer<StepOutput> device_outputs(inputs.size());
    const auto count = static_cast<uint32_t>(inputs.size());
    steps_kernel<<<(count + 127) / 128, 128, 0, stream.get()>>>(
        params_of(arrays, scene, width, height), device_inputs.data(), device_outputs.data(),
        count);
    check(cudaGetLastError());
    std::vector<StepOutput> outputs(inputs.size());
    device_outputs.download(outputs.data(), stream.get());
    return outputs;
}

std::vector<Vec3> paths_on_device(const SceneArrays& arrays, int width, int height,
                                  uint32_t sample) {
    const Stream stream;
    CudaScene scene;
    scene.upload(arrays, SceneParts::All, stream);
    const auto count = static_cast<uint32_t>(width * height);
    DeviceBuffer<Vec3> device_radiance(count);
    paths_kernel<<<(count + 127) / 128, 128, 0, stream.get()>>>(
        params_of(arrays, scene, width, height), sample, device_radiance.data());
    check(cudaGetLastError());
    std::vector<Vec3> radiance(count);
    device_radiance.download(radiance.data(), stream.get());
    return radiance;
}

}  // namespace tp::test
