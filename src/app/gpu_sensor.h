// Temperature and power of an NVIDIA card, by the driver's NVML where it is installed. A thread
// asks once a second, so that no frame waits for the driver.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace tp {

struct GpuReading {
    int temperature = 0;  // degrees Celsius
    double power = 0;     // watts; 0 = not told
    int busy_percent = -1;
};

class GpuSensor {
public:
    /// `uuid` as DeviceInfo has it; `index` counts where no card has it.
    GpuSensor(const std::string& uuid, int index);

    /// The newest reading; nothing without NVML or card.
    std::optional<GpuReading> reading() const;

private:
    void run(const std::stop_token& stop, const std::string& uuid, int index);

    mutable std::mutex mutex_;
    std::optional<GpuReading> reading_;
    std::jthread thread_;
};

}  // namespace tp
