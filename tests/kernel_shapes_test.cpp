// Shapes: intersection against a double reference, normals, texture coordinates, light sampling.
#include "support/hittables.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <random>

using namespace tp;
using namespace tp::test;

namespace {

std::mt19937& generator() {
    static std::mt19937 random(11);
    return random;
}
double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator());
}
Vec3 random_point(double size) {
    return Vec3(Double3(uniform(-size, size), uniform(-size, size), uniform(-size, size)));
}
Vec3 random_direction() {
    for (;;) {
        const Vec3 d = random_point(1);
        if (length_squared(d) > Real(0.01) && length_squared(d) < 1) return normalize(d);
    }
}

// Distance along the ray to a sphere in double, or a negative number.
double reference_distance(const Sphere& s, Vec3 origin, Vec3 direction) {
    const Double3 o = Double3(origin) - Double3(s.center), d(direction);
    const double a = glm::dot(d, d), b = glm::dot(o, d),
                 c = glm::dot(o, o) - double(s.radius) * double(s.radius);
    const double discriminant = b * b - a * c;
    if (discriminant < 0) return -1;
    const double root = std::sqrt(discriminant);
    const double near = (-b - root) / a, far = (-b + root) / a;
    return near > 0 ? near : far;
}

}  // namespace

TEST_CASE("T13: a million rays against spheres agree with double precision") {
    int misses = 0, false_hits = 0;
    double worst = 0;
    for (int i = 0; i < 1000000; ++i) {
        const Sphere s{random_point(5), static_cast<Real>(uniform(0.1, 3))};
        const Vec3 o = random_point(8);
        const Vec3 d = i % 3 == 0 ? normalize(s.center + random_direction() * s.radius - o)
                                  : random_direction();  // a third grazing
        const double expected = reference_distance(s, o, d);
        Hit hit;
        const bool met = intersect(s, o, d, kInfinity, hit);
        const double closest = glm::length(glm::cross(Double3(d), Double3(s.center) - Double3(o)));
        const bool grazing =
            std::abs(closest - double(s.radius)) <
            1e-5 * (1 + double(s.radius) + glm::length(Double3(s.center) - Double3(o)));
        if (met != (expected > 0)) {
            misses += !met && !grazing && expected > 1e-4;
            false_hits += met && !grazing;
            continue;
        }
        // Rounding moves a grazing root by much; elsewhere the distance is good to 1e-5 of the
        // scale.
        if (met && !grazing)
            worst = std::max(
                worst,
                std::abs(double(hit.t) - expected) / std::max(expected, 0.1 + double(s.radius)) *
                    std::sqrt(std::max(
                        0.0, 1 - closest * closest / (double(s.radius) * double(s.radius)))));
    }
    CHECK(misses == 0);
    CHECK(false_hits == 0);
    CHECK(worst < 1e-5);
}

TEST_CASE("T13: rays along the axes, from within, and spheres of radius 0 make no NaN") {
    for (const Vec3& d : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1)}) {
        for (Hittable& h : std::vector<Hittable>(one_of_each())) {
            Hit hit;
            if (intersect(h, {0, 0, 0}, d, kInfinity, hit)) {
                CHECK(std::isfinite(hit.t));
                CHECK(hit.t > 0);
                const SurfacePoint p = surface_at(h, {0, 0, 0}, d, hit);
                CHECK(is_finite(p.position));
                CHECK(length(p.normal) == doctest::Approx(1).epsilon(1e-5));
            }
        }
    }
    Hit hit;
    CHECK_FALSE(intersect(Sphere{{0, 0, 0}, 0}, {0, 0, 5}, {0, 0, -1}, kInfinity, hit));
}

TEST_CASE("hits lie on the surface, and leaving rays do not meet it again") {
    for (const Hittable& base : one_of_each()) {
        CAPTURE(static_cast<int>(base.kind));
        int hits = 0, again = 0;
        for (int i = 0; i < 100000; ++i) {
            const Vec3 target = random_point(1);
            const Vec3 o = random_point(6);
            const Vec3 d = normalize(target - o);
            Hit hit;
            if (!intersect(base, o, d, kInfinity, hit)) continue;
            ++hits;
            const SurfacePoint p = surface_at(base, o, d, hit);
            CHECK(length(p.position - (o + d * hit.t)) < Real(2e-5));
            // Leave on either side, at any angle.
            Vec3 out = random_direction();
            const Vec3 start = offset_ray_origin(p.position, p.error, p.normal, out);
            Hit second;
            if (!intersect(base, start, out, kInfinity, second)) continue;
            // Inwards a closed shape is met on its far side; never at the start.
            const bool closed = base.kind == HittableKind::Sphere ||
                                base.kind == HittableKind::Ellipsoid ||
                                base.kind == HittableKind::Box;
            again += !closed || dot(out, p.normal) > 0;
        }
        CHECK(hits > 1000);
        CHECK(again == 0);
    }
}

TEST_CASE("offsets hold for large and for far-off spheres") {
    for (const auto& [center, size] : {std::pair{Vec3(0, -1000, 0), Real(1000)},
                                       {Vec3(1000, 500, -2000), Real(0.5)},
                                       {Vec3(0, 0, 0), Real(1e-3)},
                                       {Vec3(0, -1e5f, 0), Real(1e5)}}) {
        const Real radius = size;  // a structured binding cannot be captured
        int again = 0;
        for (int i = 0; i < 100000; ++i) {
            const Sphere s{center, radius};
            const Vec3 o =
                center + random_direction() * (radius * static_cast<Real>(uniform(1.001, 3)));
            const Vec3 d = normalize(center + random_direction() * radius * Real(0.7) - o);
            Hit hit;
            if (!intersect(s, o, d, kInfinity, hit)) continue;
            const SurfacePoint p = surface_at(s, o, d, hit);
            Vec3 out = random_direction();
            if (dot(out, p.normal) < 0) out = -out;
            Hit second;
            again += intersect(s, offset_ray_origin(p.position, p.error, p.normal, out), out,
                               kInfinity, second);
        }
        CAPTURE(radius);
        CHECK(again == 0);
    }
}

TEST_CASE("T14: normals point outwards; inside_out turns them round") {
    for (Hittable h : one_of_each()) {
        Hit hit;
        Vec3 o, d;
        do {
            o = random_direction() * Real(9);
            d = normalize(random_point(1) - o);
        } while (!intersect(h, o, d, kInfinity, hit));
        const Vec3 n = surface_at(h, o, d, hit).normal;
        const bool closed = h.kind == HittableKind::Sphere || h.kind == HittableKind::Ellipsoid ||
                            h.kind == HittableKind::Box;
        if (closed) CHECK(dot(n, d) < 0);
        h.inside_out = 1;
        CHECK(surface_at(h, o, d, hit).normal == -n);
    }
}

TEST_CASE("texture coordinates: v = 0 on top, u to the right") {
    const auto uv_from = [](const Hittable& h, Vec3 o, Vec3 target) {
        Hit hit;
        const Vec3 d = normalize(target - o);
        REQUIRE(intersect(h, o, d, kInfinity, hit));
        return texture_uv(h, surface_at(h, o, d, hit));
    };
    const Hittable ball = sphere({0, 0, 0}, 1);
    CHECK(uv_from(ball, {0, 5, 0}, {0, 0, 0}).y == doctest::Approx(0).epsilon(1e-3));
    CHECK(uv_from(ball, {0, -5, 0}, {0, 0, 0}).y == doctest::Approx(1));
    CHECK(uv_from(ball, {0, 0, 5}, {0, 0, 0}).x == doctest::Approx(0.25));
    CHECK(uv_from(ball, {5, 0, 0}, {0, 0, 0}).x == doctest::Approx(0.5));
    const Hittable cube = box({0, 0, 0}, Mat3(1));
    // Seen from +z: right is +x, up is +y.
    Vec2 uv = uv_from(cube, {Real(0.5), Real(0.5), 5}, {Real(0.5), Real(0.5), 0});
    CHECK(uv.x == doctest::Approx(0.75));
    CHECK(uv.y == doctest::Approx(0.25));
    // Seen from +x: right is -z.
    uv = uv_from(cube, {5, Real(0.5), Real(-0.5)}, {0, Real(0.5), Real(-0.5)});
    CHECK(uv.x == doctest::Approx(0.75));
    CHECK(uv.y == doctest::Approx(0.25));
    // A quarter turn of a disk about its normal is a quarter of u.
    const Hittable disk = flat(HittableKind::Disk, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    uv = uv_from(disk, {0, Real(0.5), 5}, {0, Real(0.5), 0});
    CHECK(uv.x == doctest::Approx(0.25));
    CHECK(uv.y == doctest::Approx(0.5));
}

TEST_CASE("light sampling: directions meet the shape, the density is the one that pdf_toward has") {
    for (const Hittable& h : one_of_each()) {
        for (const Vec3& from : {Vec3(3, 2, 4), Vec3(-2, 3, Real(0.5)), Vec3(0, 8, 1)}) {
            CAPTURE(static_cast<int>(h.kind));
            int missed = 0;
            double worst = 0;
            for (int i = 0; i < 20000; ++i) {
                const ShapeSample s = sample_toward(
                    h, from, {static_cast<Real>(uniform(0, 1)), static_cast<Real>(uniform(0, 1))});
                if (!(s.pdf > 0)) continue;
                CHECK(length(s.direction) == doctest::Approx(1).epsilon(1e-5));
                CHECK(length(from + s.direction * s.distance - s.point.position) < Real(1e-4));
                Hit hit;
                if (!intersect(h, from, s.direction, kInfinity, hit)) {
                    ++missed;  // at the very rim
                    continue;
                }
                const SurfacePoint p = surface_at(h, from, s.direction, hit);
                const Real pdf = pdf_toward(h, from, s.direction, p, hit.t);
                if (std::abs(dot(p.normal, s.direction)) > Real(0.02))
                    worst = std::max(worst, std::abs(static_cast<double>(pdf / s.pdf) - 1));
            }
            CHECK(missed < 40);
            CHECK(worst < 5e-3);
        }
    }
}

TEST_CASE("light sampling: mean of 1 / pdf is the solid angle that a ray count finds") {
    for (const Hittable& h : one_of_each()) {
        CAPTURE(static_cast<int>(h.kind));
        const Vec3 from{2, Real(1.5), Real(2.5)};
        const int n = 400000;
        double sum = 0;
        int count = 0;
        for (int i = 0; i < n; ++i) {
            const ShapeSample s = sample_toward(
                h, from, {static_cast<Real>(uniform(0, 1)), static_cast<Real>(uniform(0, 1))});
            Hit hit;
            // A box hides some of the points of its visible faces never; flat shapes none.
            if (s.pdf > 0 && intersect(h, from, s.direction, kInfinity, hit))
                sum += 1 / static_cast<double>(s.pdf);
            count += intersect(h, from, random_direction(), kInfinity, hit);
        }
        const double share = static_cast<double>(count) / n,
                     error = 4 * 3.14159265 * std::sqrt(share / n);
        CHECK(std::abs(sum / n - 4 * 3.14159265 * share) < 4 * error);
    }
}

TEST_CASE("light sampling from within a closed shape covers the whole sphere of directions") {
    for (const Hittable& h :
         {sphere({0, 0, 0}, 1), ellipsoid({0, 0, 0}, kAxes), box({0, 0, 0}, kAxes)}) {
        const Vec3 from{Real(0.1), Real(0.05), Real(0.2)};
        double sum = 0;
        const int n = 200000;
        for (int i = 0; i < n; ++i) {
            const ShapeSample s = sample_toward(
                h, from, {static_cast<Real>(uniform(0, 1)), static_cast<Real>(uniform(0, 1))});
            if (s.pdf > 0) sum += 1 / static_cast<double>(s.pdf);
        }
        CAPTURE(static_cast<int>(h.kind));
        CHECK(sum / n == doctest::Approx(4 * 3.14159265).epsilon(0.01));
    }
}
