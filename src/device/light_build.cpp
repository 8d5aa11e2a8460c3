#include "light_tree_build.h"

#include <teapath/core/color.h>
#include <teapath/core/parallel.h>
#include <teapath/device/host_view.h>
#include <teapath/device/light_build.h>
#include <teapath/kernel/light.h>

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

// The share of its brightest place that a textured light counts as at least: what lies between the
// places that are looked at may be bright.
constexpr double kDarkShare = 0.05;

// Finds box, normals and power of each light.
class EmitterSurvey {
public:
    explicit EmitterSurvey(const SceneArrays& arrays) : view_(host_view(arrays, meshes_)) {}

    EmitterBounds bounds_of(const LightRecord& light) const {
        const Hittable& h = view_.hittables[light.hittable];
        const MaterialRecord& m = view_.materials[h.material];
        EmitterBounds e;
        e.two_sided = m.side == EmissionSide::Both;
        double area;
        if (h.kind == HittableKind::Mesh) {
            area = add_triangle(h, light.primitive, e);
        } else {
            e.box = tp::bounds_of(h);
            area = static_cast<double>(area_of(h));
            const bool is_flat = h.kind == HittableKind::Rectangle ||
                                 h.kind == HittableKind::Disk || h.kind == HittableKind::Triangle;
            e.cos_spread = is_flat ? 1 : -1;
            if (is_flat) {
                const Vec3 normal = normalize(cross(h.rectangle.edge_u, h.rectangle.edge_v));
                e.axis = h.inside_out ? -normal : normal;
            }
        }
        e.cos_reach = m.cone_gain == 0 ? Real(0) : m.cone_cosine;
        e.power = luminance_of(light, h, m) * area * (e.two_sided ? 2 : 1);
        return e;
    }

private:
    double add_triangle(const Hittable& h, uint32_t primitive, EmitterBounds& e) const {
        const InstanceRecord& instance = view_.instances[h.mesh.instance];
        const MeshTriangle& t = view_.meshes[instance.mesh].triangles[primitive];
        for (const Vec3& corner : {t.a.position, t.b.position, t.c.position})
            e.box = join(e.box, instance.world_from_object.point(corner));
        const Vec3 normal = mesh_point(instance, t, {1, 0, 0}).normal;
        e.axis = h.inside_out ? -normal : normal;
        e.cos_spread = 1;
        return static_cast<double>(area_of(instance, t));
    }

    double luminance_of(const LightRecord& light, const Hittable& h,
                        const MaterialRecord& m) const {
        if (m.emission.texture < 0)
            return std::max(0.0, static_cast<double>(luminance(m.emission.color)));
        double sum = 0;
        constexpr int kSide = 4;
        for (int i = 0; i < kSide * kSide; ++i) {
            const Vec2 u{(static_cast<Real>(i % kSide) + Real(0.5)) / kSide,
                         (static_cast<Real>(i / kSide) + Real(0.5)) / kSide};
            sum += luminance_at(light, h, m, u);
        }
        const double mean = sum / (kSide * kSide);
        return std::max(mean, kDarkShare * static_cast<double>(m.strength));
    }

    double luminance_at(const LightRecord& light, const Hittable& h, const MaterialRecord& m,
                        Vec2 u) const {
        const Vec3 from = h.kind == HittableKind::Mesh ? Vec3(0) : outside_of(h);
        const ShapeSample sample = sample_emitter<kFeatureAll>(view_, light, from, u);
        const Surface s = surface_of_emitter<kFeatureAll>(view_, light, h, sample.point);
        const auto l = static_cast<double>(luminance(emitted_radiance<kFeatureAll>(view_, m, s)));
        return std::isfinite(l) ? std::max(l, 0.0) : 0;
    }

    static Vec3 outside_of(const Hittable& h) {
        const Bounds b = tp::bounds_of(h);
        return b.high + b.extent() + Vec3(1);
    }

    std::vector<MeshView> meshes_;
    SceneView view_;
};

std::vector<LightRecord> find_lights(SceneArrays& arrays) {
    std::vector<LightRecord> lights;
    for (size_t i = 0; i < arrays.hittables.size(); ++i) {
        Hittable& h = arrays.hittables[i];
        h.light = kNoLight;
        if (!arrays.materials[h.material].emits) continue;
        h.light = static_cast<uint32_t>(lights.size());
        size_t count = 1;
        if (h.kind == HittableKind::Mesh) {
            const uint32_t mesh = arrays.instances[h.mesh.instance].mesh;
            count = arrays.meshes[mesh].arrays->triangles.size();
        }
        for (size_t t = 0; t < count; ++t)
            lights.push_back({static_cast<uint32_t>(i), static_cast<uint32_t>(t), 0});
    }
    return lights;
}

}  // namespace

void build_lights(SceneArrays& arrays) {
    arrays.lights = find_lights(arrays);
    std::vector<EmitterBounds> emitters(arrays.lights.size());
    const EmitterSurvey survey(arrays);
    parallel_for(static_cast<int64_t>(emitters.size()), 1024, [&](int64_t first, int64_t last) {
        for (auto i = static_cast<size_t>(first); i < static_cast<size_t>(last); ++i)
            emitters[i] = survey.bounds_of(arrays.lights[i]);
    });
    LightTree tree = build_light_tree(emitters);
    for (size_t i = 0; i < arrays.lights.size(); ++i)
        arrays.lights[i].trail = tree.trails[i];
    arrays.light_nodes = std::move(tree.nodes);

    // The power of the environment cannot be told from that of lights near by: beside others it has
    // half of the samples.
    const bool aims = arrays.environment && max_component(arrays.background.scale) > 0;
    arrays.background.light_probability = !aims                   ? Real(0)
                                          : arrays.lights.empty() ? Real(1)
                                                                  : Real(0.5);
}

}  // namespace tp
