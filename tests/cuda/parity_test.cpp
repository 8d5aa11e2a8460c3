// Host against CUDA: each step on the same inputs within a few ulp, and how many paths part
// company.
#include "cuda/parity.h"

#include "cuda/steps.h"
#include "support/scene_maker.h"
#include "support/shipped_scenes.h"

#include <teapath/device/host_view.h>
#include <teapath/io/scene_file.h>
#include <teapath/render/session.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

using namespace tp;
using namespace tp::test;

namespace {

// Everything that the foundation has in one room: all shapes, all materials, textures, two lights.
Scene full_scene() {
    SceneMaker maker;
    maker.scene.render.width = 160;
    maker.scene.render.height = 120;
    maker.scene.background.kind = BackgroundKind::Gradient;
    maker.camera().look_from = {0, 2, 7};
    maker.camera().look_at = {0, 0.8, 0};
    maker.camera().aperture = 0.1;
    Texture checker;
    checker.kind = TextureKind::Checker;
    Material ground;
    ground.color.texture = maker.texture(checker);
    maker.object(XzRectShape{{-8, -8}, {8, 8}, 0}, maker.material(ground));
    maker.sphere({-2, 0.7, 0}, 0.7, maker.glass(1.5));
    maker.sphere({0, 0.7, 0}, 0.7, maker.metal(0.9, 0.2));
    maker.sphere({2, 0.7, 0}, 0.7, maker.metal(0.9, 0));
    Object& egg = maker.sphere({0, 0, 0}, 0.5, maker.lambertian(0.6));
    egg.transform.translation = {-1, 0.5, 2};
    egg.transform.rotation = {10, 20, 40};
    egg.transform.scale = {1, 0.6, 1.4};
    Object& crate = maker.object(BoxShape{}, maker.lambertian(0.4));
    crate.transform.translation = {1.2, 0.5, 2};
    crate.transform.rotation = {0, 30, 0};
    maker.object(TriangleShape{{-3, 0, -2}, {3, 0, -2}, {0, 4, -2}}, maker.lambertian(0.7));
    maker.object(DiskShape{{3, 1, 1}, {-1, 0.2, 0.1}, 0.8}, maker.metal(0.7, 0.6));
    maker.sphere({-3, 3, 2}, 0.3, maker.light(20));
    maker.object(XzRectShape{{1, 0}, {2, 1}, 4}, maker.light(10)).inside_out = true;
    Material veil;
    veil.opacity = 0.5;
    maker.object(DiskShape{{0, 2, 1}, {0, 1, 0.2}, 1}, maker.material(veil));
    return maker.scene;
}

LaunchParams host_params(const SceneArrays& arrays, int width, int height,
                         std::vector<MeshView>& meshes) {
    LaunchParams params;
    params.scene = host_view(arrays, meshes);
    params.camera = arrays.camera;
    params.settings = arrays.settings;
    params.key = tea_key(0, arrays.settings.seed, arrays.settings.key_rounds);
    params.width = width;
    params.height = height;
    return params;
}

// Every state that the paths of one sample pass through.
std::vector<StepInput> record_inputs(const LaunchParams& params) {
    std::vector<StepInput> inputs;
    for (uint32_t y = 0; y < static_cast<uint32_t>(params.height); ++y) {
        for (uint32_t x = 0; x < static_cast<uint32_t>(params.width); ++x) {
            const uint32_t pixel = y * static_cast<uint32_t>(params.width) + x;
            const Sampler sampler = path_sampler(params, pixel, 0);
            PathState path = start_camera_path<kFeatureAll>(params, sampler, x, y);
            for (bool goes_on = true; goes_on;) {
                const Hit hit = intersect<kFeatureAll>(params, path);
                inputs.push_back({path, pixel, 0, hit});
                ShadowQuery shadow;
                goes_on = shade<kFeatureAll>(params, sampler, hit, path, shadow);
                connect_to_light<kFeatureAll>(params, shadow, path);
            }
        }
    }
    return inputs;
}

// Differences in units of the float spacing at the size of the larger vector.
double ulps(Vec3 a, Vec3 b) {
    const Vec3 d = abs(a - b);
    const double scale =
        std::max({1e-3, double(max_component(abs(a))), double(max_component(abs(b)))});
    return double(max_component(d)) / (scale * 1.1920929e-7);
}

struct Spread {
    std::vector<double> values;
    void add(double x) { values.push_back(x); }
    double quantile(double q) {
        if (values.empty()) return 0;
        std::sort(values.begin(), values.end());
        return values[static_cast<size_t>(q * static_cast<double>(values.size() - 1))];
    }
    void print(const char* name) {
        std::printf("  %-22s median %.1f, 99%% %.1f, 99.9%% %.1f ulp (%zu)\n", name, quantile(0.5),
                    quantile(0.99), quantile(0.999), values.size());
    }
};

bool without_device() {
    if (backend_name() == "cuda") return false;
    MESSAGE("needs a GPU: run with --backend cuda");
    return true;
}

}  // namespace

TEST_CASE("each step gives the same on host and CUDA, within a few ulp") {
    if (without_device()) return;
    const Scene scene = full_scene();
    SceneArrays arrays;
    flatten(scene, SceneParts::All, arrays);
    std::vector<MeshView> meshes;
    const LaunchParams params = host_params(arrays, 160, 120, meshes);
    const std::vector<StepInput> inputs = record_inputs(params);
    const std::vector<StepOutput> device = steps_on_device(arrays, 160, 120, inputs);

    Spread distance, origin, direction, throughput, radiance, shadow_light;
    size_t other_hits = 0, other_choices = 0, other_shadows = 0;
    for (size_t i = 0; i < inputs.size(); ++i) {
        const StepOutput a = run_steps(params, inputs[i]), &b = device[i];
        if (a.hit.index != b.hit.index) {
            ++other_hits;
        } else if (a.hit.index != kNoHit) {
            distance.add(ulps(Vec3(a.hit.t), Vec3(b.hit.t)));
        }
        // A choice by a random number that lies between the two probabilities falls differently.
        if (a.goes_on != b.goes_on || a.path.depth != b.path.depth ||
            length(a.path.direction - b.path.direction) > Real(0.01)) {
            ++other_choices;
            continue;
        }
        origin.add(ulps(a.path.origin, b.path.origin));
        direction.add(ulps(a.path.direction, b.path.direction));
        throughput.add(ulps(a.path.throughput, b.path.throughput));
        radiance.add(ulps(a.path.radiance, b.path.radiance));
        if (a.shadow.is_active && b.shadow.is_active) {
            shadow_light.add(ulps(a.shadow.contribution, b.shadow.contribution));
            other_shadows += length(a.light - b.light) > Real(0.01);
        }
    }
    distance.print("distance");
    origin.print("origin");
    direction.print("direction");
    throughput.print("throughput");
    radiance.print("radiance");
    shadow_light.print("light's contribution");
    const auto count = static_cast<double>(inputs.size());
    std::printf("  of %.0f steps: %.4f %% other hit, %.4f %% other choice, %.4f %% other shadow\n",
                count, 100 * static_cast<double>(other_hits) / count,
                100 * static_cast<double>(other_choices) / count,
                100 * static_cast<double>(other_shadows) / count);
    CHECK(static_cast<double>(other_hits) < 1e-3 * count);
    CHECK(static_cast<double>(other_choices) < 1e-3 * count);
    CHECK(static_cast<double>(other_shadows) < 1e-3 * count);
    for (Spread* s : {&distance, &origin, &direction, &throughput, &radiance, &shadow_light}) {
        CHECK(s->quantile(0.5) <= 4);
        CHECK(s->quantile(0.99) <= 256);
    }
}

// Traces one sample of every pixel on both and compares.
void check_paths(const char* name, const Scene& scene) {
    CAPTURE(name);
    constexpr int kWidth = 160, kHeight = 120;
    SceneArrays arrays;
    flatten(scene, SceneParts::All, arrays);
    std::vector<MeshView> meshes;
    const LaunchParams params = host_params(arrays, kWidth, kHeight, meshes);
    const std::vector<Vec3> device = paths_on_device(arrays, kWidth, kHeight, 3);
    size_t parted = 0;
    double host_sum = 0, device_sum = 0;
    for (uint32_t i = 0; i < device.size(); ++i) {
        const Vec3 host = run_path(params, i % kWidth, i / kWidth, 3);
        parted += length(host - device[i]) > Real(1e-2) * (Real(0.01) + length(host));
        host_sum += static_cast<double>(luminance(host));
        device_sum += static_cast<double>(luminance(device[i]));
    }
    const auto count = static_cast<double>(device.size());
    std::printf("  %-24s %zu of %zu paths part company; means %.5f and %.5f\n", name, parted,
                device.size(), host_sum / count, device_sum / count);
    CHECK(static_cast<double>(parted) < 0.01 * count);
    CHECK(device_sum == doctest::Approx(host_sum).epsilon(0.01));
}

TEST_CASE("few paths part company between host and CUDA, and they agree on average") {
    if (without_device()) return;
    check_paths("all shapes, all materials", full_scene());
    for (const char* name : {"cornell_box.json", "showcase.json", "weekend/12_final.json"}) {
        Scene scene = load_scene(scene_folder() / name);
        scene.render.width = 160;  // of the camera's rays
        scene.render.height = 120;
        check_paths(name, scene);
    }
}

// Lanes that left the tree early once overwrote uniform registers of those still in it: some tens
// of millions of rays among many meshes met that.
TEST_CASE("feature planes of scenes of many meshes take many samples") {
    if (without_device()) return;
    for (const char* name : {"gallery/room.json", "gallery/forest.json"}) {
        auto scene = std::make_shared<Scene>(load_scene(scene_folder() / name));
        scene->render.width = 320;
        scene->render.height = 180;
        scene->render.path.seed = 1;
        scene->render.path.max_depth = 1;
        SessionOptions options;
        options.backend = BackendKind::Cuda;
        options.features = true;
        Session session(options);
        session.sync(scene);
        for (const int64_t samples : {700, 1300}) {
            session.step(samples);
            CHECK(session.film().samples == session.samples());
        }
    }
}
