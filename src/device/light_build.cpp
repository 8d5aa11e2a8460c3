#include "alias_table.h"

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

// The environment comes last. Its power cannot be told from that of lights near by: beside others
// it has half of the samples.
void add_environment(SceneArrays& arrays, Emitters& emitters) {
    arrays.background.light_probability = 0;
    if (!arrays.environment || !(arrays.background.strength > 0)) return;
    const double share = emitters.lights.empty() ? 1 : 0.5;
    for (double& p : emitters.power)
        p *= 1 - share;
    emitters.add(kEnvironmentLight, 0, share);
    arrays.background.light_probability = static_cast<Real>(share);
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
    for (double& p : power)
        p = total > 0 ? 0.9 * p / total + 0.1 / count : 1 / count;
    add_environment(arrays, emitters);
    for (size_t i = 0; i < lights.size(); ++i)
        lights[i].probability = static_cast<Real>(power[i]);
    fill_alias_table(lights.data(), power);
    arrays.lights = std::move(lights);
}

}  // namespace tp
