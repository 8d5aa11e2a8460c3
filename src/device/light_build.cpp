#include <teapath/core/color.h>
#include <teapath/device/light_build.h>
#include <teapath/kernel/mesh/mesh_surface.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

// Power for each unit of area, up to a common factor; textures count as white.
double power_of_area(const MaterialRecord& m) {
    const double radiance = m.emission.texture >= 0
                                ? static_cast<double>(m.strength)
                                : static_cast<double>(luminance(m.emission.color));
    return std::max(0.0, radiance) * (m.side == EmissionSide::Both ? 2 : 1);
}

// The emitters, and the power of each.
struct Emitters {
    std::vector<LightRecord> lights;
    std::vector<double> power;

    void add(size_t hittable, size_t primitive, double emitter_power) {
        lights.push_back(
            {static_cast<uint32_t>(hittable), static_cast<uint32_t>(primitive), 0, 1, 0});
        power.push_back(emitter_power);
    }
};

void add_mesh(const SceneArrays& arrays, size_t hittable, double power, Emitters& emitters) {
    const InstanceRecord& instance = arrays.instances[arrays.hittables[hittable].mesh.instance];
    const std::vector<MeshTriangle>& triangles = arrays.meshes[instance.mesh].arrays->triangles;
    for (size_t t = 0; t < triangles.size(); ++t)
        emitters.add(hittable, t, power * static_cast<double>(area_of(instance, triangles[t])));
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

void build_lights(SceneArrays& arrays) {
    Emitters emitters;
    for (size_t i = 0; i < arrays.hittables.size(); ++i) {
        Hittable& h = arrays.hittables[i];
        h.light = kNoLight;
        const MaterialRecord& m = arrays.materials[h.material];
        if (!m.emits) continue;
        h.light = static_cast<uint32_t>(emitters.lights.size());
        if (h.kind == HittableKind::Mesh)
            add_mesh(arrays, i, power_of_area(m), emitters);
        else
            emitters.add(i, 0, power_of_area(m) * static_cast<double>(area_of(h)));
    }
    std::vector<LightRecord>& lights = emitters.lights;
    std::vector<double>& power = emitters.power;
    double total = 0;
    for (const double p : power)
        total += p;
    const auto count = static_cast<double>(lights.size());
    for (size_t i = 0; i < lights.size(); ++i) {
        power[i] = total > 0 ? 0.9 * power[i] / total + 0.1 / count : 1 / count;
        lights[i].probability = static_cast<Real>(power[i]);
    }
    fill_alias_table(lights, power);
    arrays.lights = std::move(lights);
}

}  // namespace tp
