// Rate of the sphere scenes: bench_spheres FILE [samples] [host|cuda] [rounds]. Prints Msamples/s,
// best of five, and the mean radiance. A scene file has the camera in its first line (look-from,
// look-at, vertical field of view, aperture, focus distance), a count, then a sphere a line: x y z
// radius material r g b parameter.
#include <teapath/core/error.h>
#include <teapath/render/kernel_report.h>
#include <teapath/render/session.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

namespace {

tp::Scene read_spheres(const char* path) {
    std::ifstream file(path);
    tp::Scene scene;
    tp::Camera camera;
    camera.id = {1};
    std::string word;
    file >> word >> camera.look_from.x >> camera.look_from.y >> camera.look_from.z >>
        camera.look_at.x >> camera.look_at.y >> camera.look_at.z >> camera.vertical_fov >>
        camera.aperture >> camera.focus_distance;
    scene.cameras = {camera};
    size_t count = 0;
    file >> count;
    for (uint32_t i = 1; i <= count; ++i) {
        tp::SphereShape sphere;
        int kind = 0;
        tp::Double3 color;
        double parameter = 0;
        file >> sphere.center.x >> sphere.center.y >> sphere.center.z >> sphere.radius >> kind >>
            color.x >> color.y >> color.z >> parameter;
        tp::Material material;
        material.id = {i};
        material.kind = kind == 0   ? tp::MaterialKind::Lambertian
                        : kind == 1 ? tp::MaterialKind::Metal
                                    : tp::MaterialKind::Dielectric;
        material.color.color = kind == 2 ? tp::Double3(1, 1, 1) : color;
        if (kind == 1) material.fuzz = parameter;
        if (kind == 2) material.ior = parameter;
        scene.materials.edit().push_back(material);
        tp::Object object;
        object.id = {i};
        object.shape = sphere;
        object.material = {i};
        scene.objects.edit().push_back(object);
    }
    scene.render.width = 1200;
    scene.render.height = 800;
    scene.render.path.max_depth = 50;
    scene.render.path.roulette_depth = 0;
    return scene;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 2) return std::puts("bench_spheres FILE [samples] [host|cuda] [rounds]"), 2;
    tp::Scene scene = read_spheres(argv[1]);
    const int samples = argc > 2 ? std::atoi(argv[2]) : 100;
    tp::SessionOptions options;
    options.backend =
        argc > 3 && std::string(argv[3]) == "cuda" ? tp::BackendKind::Cuda : tp::BackendKind::Host;
    if (argc > 4) scene.render.path.tea_rounds = std::atoi(argv[4]);
    if (const char* threads = std::getenv("THREADS")) options.threads = std::atoi(threads);
    tp::Session session(options);
    session.sync(std::make_shared<tp::Scene>(scene));
    const int repeats = options.backend == tp::BackendKind::Cuda ? 6 : 2;
    double best = 1e30;
    for (int i = 0; i < repeats; ++i) {
        const auto start = std::chrono::steady_clock::now();
        session.step(samples);
        best = std::min(
            best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    const tp::FilmImage film = session.film();
    double mean[3] = {0, 0, 0};
    for (size_t i = 0; i < film.radiance.size(); ++i)
        mean[i % 3] += film.radiance[i];
    const double pixels = static_cast<double>(film.radiance.size()) / 3;
    fmt::print(
        "{} {} spp on {}: {:.1f} Msamples/s, {:.2f} ms, mean {:.6f} {:.6f} {:.6f}, tree depth {}, "
        "cost {:.1f}\n",
        argv[1], samples, session.backend_name(), pixels * samples / best / 1e6, best * 1e3,
        mean[0] / pixels, mean[1] / pixels, mean[2] / pixels, session.arrays().bvh.depth,
        session.arrays().bvh.sah_cost);
    if (options.backend == tp::BackendKind::Cuda) {
        for (const tp::KernelReport& k : tp::kernel_reports())
            fmt::print(
                "  {}: {} registers, {} bytes of stack, {} threads a block, occupancy {:.1f} %\n",
                k.name, k.registers, k.stack_bytes, k.threads, 100 * k.occupancy);
    }
    if (argc > 5) {
        const auto rgb = session.display();
        std::ofstream out(argv[5], std::ios::binary);
        out << "P6\n1200 800\n255\n";
        out.write(reinterpret_cast<const char*>(rgb.data()),
                  static_cast<std::streamsize>(rgb.size()));
    }
    return 0;
} catch (const tp::Error& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return error.exit_code();
}
