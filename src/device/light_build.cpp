#include <teapath/core/color.h>
#include <teapath/device/light_build.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

// Power up to a common factor; textures count as white.
double power_of(const Hittable& h, const MaterialRecord& m) {
    const double radiance = m.emission.texture >= 0
                                ? static_cast<double>(m.strength)
                                : static_cast<double>(luminance(m.emission.color));
    const double sides = m.side == EmissionSide::Both ? 2 : 1;
    return std::max(0.0, radiance) * sides * static_cast<double>(area_of(h));
}

// Vose's construction: every column is filled up by one other.
void fill_alias_table(std::vector<LightRecord>& lights, const std::vector<double>& probability) {
    const size_t n = lights.size();
    std::vector<double> level(n);
    std::vector<uint32_t> low, high;
    for (size_t i = 0; i < n; ++i) {
        level[i] = probability[i] * static_cast<double>(n);
        (level[i] < 1 ? low : high).push_back(static_cast<uint32_t>(i));
    }
    while (!low.empty() && !high.empty()) {
        const uint32_t small = low.back(), large = high.back();
        low.pop_back();
        lights[small].alias_threshold = static_cast<Real>(level[small]);
        lights[small].alias = large;
        level[large] -= 1 - level[small];
        if (level[large] < 1) {
            high.pop_back();
            low.push_back(large);
        }
    }
    for (const auto* rest : {&low, &high}) {
        for (const uint32_t i : *rest) {
            lights[i].alias_threshold = 1;
            lights[i].alias = i;
        }
    }
}

}  // namespace

std::vector<LightRecord> build_lights(std::vector<Hittable>& hittables,
                                      const std::vector<MaterialRecord>& materials) {
    std::vector<LightRecord> lights;
    std::vector<double> power;
    for (size_t i = 0; i < hittables.size(); ++i) {
        Hittable& h = hittables[i];
        h.light = kNoLight;
        const MaterialRecord& m = materials[h.material];
        if (!m.emits) continue;
        h.light = static_cast<uint32_t>(lights.size());
        lights.push_back({static_cast<uint32_t>(i), 0, 1, 0});
        power.push_back(power_of(h, m));
    }
    double total = 0;
    for (const double p : power)
        total += p;
    const auto count = static_cast<double>(lights.size());
    for (size_t i = 0; i < lights.size(); ++i) {
        power[i] = total > 0 ? 0.9 * power[i] / total + 0.1 / count : 1 / count;
        lights[i].probability = static_cast<Real>(power[i]);
    }
    fill_alias_table(lights, power);
    return lights;
}

}  // namespace tp
