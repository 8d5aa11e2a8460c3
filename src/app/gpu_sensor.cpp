#include "gpu_sensor.h"

#include <dlfcn.h>

#include <chrono>
#include <condition_variable>
#include <memory>

namespace tp {
namespace {

// The few calls of NVML that are used (nvml.h of the CUDA Toolkit); 0 is success everywhere.
using Device = void*;
struct Utilization {
    unsigned gpu, memory;
};
struct Nvml {
    int (*init)() = nullptr;
    int (*shutdown)() = nullptr;
    int (*by_uuid)(const char*, Device*) = nullptr;
    int (*by_index)(unsigned, Device*) = nullptr;
    int (*temperature)(Device, int, unsigned*) = nullptr;
    int (*power)(Device, unsigned*) = nullptr;
    int (*utilization)(Device, Utilization*) = nullptr;
};

template <class Function>
bool take(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    return function != nullptr;
}

bool take_all(void* library, Nvml& nvml) {
    return take(library, "nvmlInit_v2", nvml.init) &&
           take(library, "nvmlShutdown", nvml.shutdown) &&
           take(library, "nvmlDeviceGetHandleByUUID", nvml.by_uuid) &&
           take(library, "nvmlDeviceGetHandleByIndex_v2", nvml.by_index) &&
           take(library, "nvmlDeviceGetTemperature", nvml.temperature) &&
           take(library, "nvmlDeviceGetPowerUsage", nvml.power) &&
           take(library, "nvmlDeviceGetUtilizationRates", nvml.utilization);
}

// "GPU-01234567-89ab-…" of 32 hexadecimal digits, as NVML writes it.
std::string driver_name(const std::string& digits) {
    if (digits.size() != 32) return digits;
    std::string name = "GPU";
    size_t at = 0;
    for (const size_t length : {8, 4, 4, 4, 12}) {
        name += '-' + digits.substr(at, length);
        at += length;
    }
    return name;
}

std::optional<GpuReading> read(const Nvml& nvml, Device device) {
    GpuReading reading;
    unsigned celsius = 0, milliwatts = 0;
    if (nvml.temperature(device, 0, &celsius) != 0) return std::nullopt;
    reading.temperature = static_cast<int>(celsius);
    if (nvml.power(device, &milliwatts) == 0) reading.power = milliwatts / 1000.0;
    Utilization busy{};
    if (nvml.utilization(device, &busy) == 0) reading.busy_percent = static_cast<int>(busy.gpu);
    return reading;
}

}  // namespace

GpuSensor::GpuSensor(const std::string& uuid, int index)
    : thread_([this, uuid, index](const std::stop_token& stop) { run(stop, uuid, index); }) {}

std::optional<GpuReading> GpuSensor::reading() const {
    const std::lock_guard lock(mutex_);
    return reading_;
}

void GpuSensor::run(const std::stop_token& stop, const std::string& uuid, int index) {
    const auto close = [](void* library) { dlclose(library); };
    const std::unique_ptr<void, decltype(close)> library(dlopen("libnvidia-ml.so.1", RTLD_NOW),
                                                         close);
    Nvml nvml;
    if (!library || !take_all(library.get(), nvml) || nvml.init() != 0) return;
    Device device = nullptr;
    const bool found = (!uuid.empty() && nvml.by_uuid(driver_name(uuid).c_str(), &device) == 0) ||
                       nvml.by_index(static_cast<unsigned>(index), &device) == 0;
    std::mutex sleep;
    std::condition_variable_any wake;
    while (found && !stop.stop_requested()) {
        const std::optional<GpuReading> now = read(nvml, device);
        {
            const std::lock_guard lock(mutex_);
            reading_ = now;
        }
        std::unique_lock lock(sleep);
        wake.wait_for(lock, stop, std::chrono::seconds(1), [] { return false; });
    }
    nvml.shutdown();
}

}  // namespace tp
