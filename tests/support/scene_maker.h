// Small scenes for tests, made in code, and their renders.
#pragma once

#include "support/backend_option.h"

#include <teapath/render/session.h>
#include <teapath/scene/scene.h>

#include <doctest/doctest.h>

#include <functional>
#include <memory>
#include <string>

namespace tp::test {

/// Builds a scene step by step; ids count up from 1.
struct SceneMaker {
    Scene scene;

    SceneMaker() {
        Camera camera;
        camera.id = {1};
        scene.cameras = {camera};
        scene.background.kind = BackgroundKind::Constant;
        scene.render.width = 64;
        scene.render.height = 48;
    }

    Camera& camera() { return scene.cameras.front(); }
    PathSettings& path() { return scene.render.path; }

    void background(double radiance) { scene.background.color = Double3(radiance); }

    MaterialId material(Material m) {
        m.id = {static_cast<uint32_t>(scene.materials.size()) + 1};
        scene.materials.edit().push_back(m);
        return m.id;
    }
    MaterialId lambertian(double albedo) {
        Material m;
        m.color.color = Double3(albedo);
        return material(m);
    }
    MaterialId metal(double reflectance, double fuzz) {
        Material m;
        m.kind = MaterialKind::Metal;
        m.color.color = Double3(reflectance);
        m.fuzz = fuzz;
        return material(m);
    }
    MaterialId glass(double ior) {
        Material m;
        m.kind = MaterialKind::Dielectric;
        m.color.color = Double3(1);
        m.ior = ior;
        return material(m);
    }
    MaterialId light(double radiance, EmissionSide side = EmissionSide::Auto) {
        Material m;
        m.kind = MaterialKind::DiffuseLight;
        m.emission.color = Double3(radiance);
        m.side = side;
        return material(m);
    }
    TextureId texture(Texture t) {
        t.id = {static_cast<uint32_t>(scene.textures.size()) + 1};
        scene.textures.edit().push_back(t);
        return t.id;
    }

    Object& object(Shape shape, MaterialId material) {
        Object o;
        o.id = {static_cast<uint32_t>(scene.objects.size()) + 1};
        o.shape = std::move(shape);
        o.material = material;
        scene.objects.edit().push_back(std::move(o));
        return scene.objects.edit().back();
    }
    Object& sphere(Double3 center, double radius, MaterialId m) {
        return object(SphereShape{center, radius}, m);
    }
};

inline SessionOptions session_options(bool features = false, int threads = 0) {
    SessionOptions options;
    options.backend = backend_name() == "cuda" ? BackendKind::Cuda : BackendKind::Host;
    options.threads = threads;
    options.features = features;
    return options;
}

/// Renders on the runner's backend.
inline FilmImage render(const Scene& scene, int64_t samples, bool features = false,
                        int threads = 0) {
    Session session(session_options(features, threads));
    session.sync(std::make_shared<const Scene>(scene));
    REQUIRE(session.step(samples));
    CHECK(session.counters().invalid_samples == 0);
    return session.film();
}

/// Mean radiance over the picture and its channels.
inline double mean(const FilmImage& film) {
    double sum = 0;
    for (const float x : film.radiance)
        sum += static_cast<double>(x);
    return sum / static_cast<double>(film.radiance.size());
}

/// Red radiance at a pixel.
inline double red(const FilmImage& film, int x, int y) {
    return static_cast<double>(
        film.radiance[3 * (static_cast<size_t>(y) * static_cast<size_t>(film.width) +
                           static_cast<size_t>(x))]);
}

}  // namespace tp::test
