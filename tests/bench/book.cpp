// The renderer that every figure is compared with, written anew after "Ray Tracing in One Weekend"
// (Shirley, Black, Hollasch): doubles, virtual objects behind shared pointers, recursion, a list
// without a tree, one core. bench_book FILE [samples] prints Msamples/s. FILE as for bench_spheres.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

struct Vec {
    double x = 0, y = 0, z = 0;
};
Vec operator+(Vec a, Vec b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec operator-(Vec a, Vec b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec operator*(Vec a, double s) {
    return {a.x * s, a.y * s, a.z * s};
}
Vec operator*(Vec a, Vec b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
double dot(Vec a, Vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec cross(Vec a, Vec b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec unit(Vec a) {
    return a * (1 / std::sqrt(dot(a, a)));
}

double random_number() {
    static std::mt19937 generator;
    static std::uniform_real_distribution<double> distribution(0, 1);
    return distribution(generator);
}
Vec random_in_ball() {
    for (;;) {
        const Vec p{2 * random_number() - 1, 2 * random_number() - 1, 2 * random_number() - 1};
        if (dot(p, p) < 1) return p;
    }
}

struct Ray {
    Vec origin, direction;
};
struct Material;
struct HitRecord {
    Vec p, normal;
    double t = 0;
    bool front = false;
    std::shared_ptr<Material> material;
};

struct Material {
    virtual ~Material() = default;
    virtual bool scatter(const Ray& in, const HitRecord& hit, Vec& attenuation, Ray& out) const = 0;
};
struct Lambertian : Material {
    Vec albedo;
    bool scatter(const Ray&, const HitRecord& hit, Vec& attenuation, Ray& out) const override {
        out = {hit.p, hit.normal + unit(random_in_ball())};
        attenuation = albedo;
        return true;
    }
};
struct Metal : Material {
    Vec albedo;
    double fuzz = 0;
    bool scatter(const Ray& in, const HitRecord& hit, Vec& attenuation, Ray& out) const override {
        const Vec d = unit(in.direction);
        out = {hit.p, d - hit.normal * (2 * dot(d, hit.normal)) + random_in_ball() * fuzz};
        attenuation = albedo;
        return dot(out.direction, hit.normal) > 0;
    }
};
struct Dielectric : Material {
    double index = 1.5;
    bool scatter(const Ray& in, const HitRecord& hit, Vec& attenuation, Ray& out) const override {
        attenuation = {1, 1, 1};
        const double ratio = hit.front ? 1 / index : index;
        const Vec d = unit(in.direction);
        const double cosine = std::fmin(-dot(d, hit.normal), 1),
                     sine = std::sqrt(1 - cosine * cosine);
        double r0 = (1 - ratio) / (1 + ratio);
        r0 *= r0;
        if (ratio * sine > 1 || r0 + (1 - r0) * std::pow(1 - cosine, 5) > random_number()) {
            out = {hit.p, d - hit.normal * (2 * dot(d, hit.normal))};
        } else {
            const Vec across = (d + hit.normal * cosine) * ratio;
            out = {hit.p, across - hit.normal * std::sqrt(std::fabs(1 - dot(across, across)))};
        }
        return true;
    }
};

struct Hittable {
    virtual ~Hittable() = default;
    virtual bool hit(const Ray& r, double t_min, double t_max, HitRecord& record) const = 0;
};
struct Sphere : Hittable {
    Vec center;
    double radius = 1;
    std::shared_ptr<Material> material;
    bool hit(const Ray& r, double t_min, double t_max, HitRecord& record) const override {
        const Vec oc = r.origin - center;
        const double a = dot(r.direction, r.direction), half_b = dot(oc, r.direction),
                     c = dot(oc, oc) - radius * radius;
        const double discriminant = half_b * half_b - a * c;
        if (discriminant < 0) return false;
        const double root = std::sqrt(discriminant);
        double t = (-half_b - root) / a;
        if (t < t_min || t > t_max) t = (-half_b + root) / a;
        if (t < t_min || t > t_max) return false;
        record.t = t;
        record.p = r.origin + r.direction * t;
        record.normal = (record.p - center) * (1 / radius);
        record.front = dot(r.direction, record.normal) < 0;
        if (!record.front) record.normal = record.normal * -1;
        record.material = material;
        return true;
    }
};
struct List : Hittable {
    std::vector<std::shared_ptr<Hittable>> objects;
    bool hit(const Ray& r, double t_min, double t_max, HitRecord& record) const override {
        HitRecord found;
        bool any = false;
        for (const auto& object : objects) {
            if (!object->hit(r, t_min, t_max, found)) continue;
            any = true;
            t_max = found.t;
            record = found;
        }
        return any;
    }
};

Vec ray_color(const Ray& r, const Hittable& world, int depth) {
    if (depth <= 0) return {};
    HitRecord hit;
    if (world.hit(r, 0.001, std::numeric_limits<double>::infinity(), hit)) {
        Ray out;
        Vec attenuation;
        if (!hit.material->scatter(r, hit, attenuation, out)) return {};
        return attenuation * ray_color(out, world, depth - 1);
    }
    const double t = 0.5 * (unit(r.direction).y + 1);
    return Vec{1, 1, 1} * (1 - t) + Vec{0.5, 0.7, 1} * t;
}

std::shared_ptr<Material> make_material(int kind, Vec color, double parameter) {
    if (kind == 0) {
        auto m = std::make_shared<Lambertian>();
        m->albedo = color;
        return m;
    }
    if (kind == 1) {
        auto m = std::make_shared<Metal>();
        m->albedo = color;
        m->fuzz = parameter;
        return m;
    }
    auto m = std::make_shared<Dielectric>();
    m->index = parameter;
    return m;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return std::puts("bench_book FILE [samples]"), 2;
    std::ifstream file(argv[1]);
    std::string word;
    Vec from, at;
    double fov = 0, aperture = 0, focus = 0;
    size_t count = 0;
    file >> word >> from.x >> from.y >> from.z >> at.x >> at.y >> at.z >> fov >> aperture >>
        focus >> count;
    List world;
    for (size_t i = 0; i < count; ++i) {
        auto sphere = std::make_shared<Sphere>();
        int kind = 0;
        Vec color;
        double parameter = 0;
        file >> sphere->center.x >> sphere->center.y >> sphere->center.z >> sphere->radius >>
            kind >> color.x >> color.y >> color.z >> parameter;
        sphere->material = make_material(kind, color, parameter);
        world.objects.push_back(sphere);
    }
    const int width = 1200, height = 800, samples = argc > 2 ? std::atoi(argv[2]) : 1;
    const double half = std::tan(fov * 3.14159265358979323846 / 360);
    const Vec w = unit(from - at), u = unit(cross({0, 1, 0}, w)), v = cross(w, u);
    Vec mean;
    const auto start = std::chrono::steady_clock::now();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int s = 0; s < samples; ++s) {
                const double px = (2 * (x + random_number()) / width - 1) * half * width / height,
                             py = (1 - 2 * (y + random_number()) / height) * half;
                Vec lens = random_in_ball();
                lens = (u * lens.x + v * lens.y) * (aperture / 2);
                const Vec target = from + (u * px + v * py - w) * focus;
                mean = mean + ray_color({from + lens, target - from - lens}, world, 50);
            }
        }
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
                               .count(),
                 total = double(width) * height * samples;
    std::printf("%s %d spp, the book on one core: %.3f Msamples/s, mean %.6f %.6f %.6f\n", argv[1],
                samples, total / seconds / 1e6, mean.x / total, mean.y / total, mean.z / total);
    return 0;
}
