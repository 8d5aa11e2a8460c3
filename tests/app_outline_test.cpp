// The outline of the selection against tracing: a ray meets the object exactly where its point of
// the picture lies inside the outline.
#include "app/fly_camera.h"
#include "app/viewport/outline.h"
#include "support/scene_maker.h"

#include <teapath/device/pick.h>

#include <cmath>
#include <random>

using namespace tp;
using namespace tp::test;

namespace {

constexpr double kAspect = 16.0 / 9, kHeight = 720;

// Distance of a point inside a convex polygon to its edges in picture heights; negative outside.
double depth_inside(const std::vector<Double2>& polygon, const Double2& p) {
    if (polygon.size() < 3) return -1e9;
    const Double2 stretch(kAspect, 1);
    double depth = 1e9, area = 0;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Double2 a = polygon[i] * stretch, b = polygon[(i + 1) % polygon.size()] * stretch;
        area += a.x * b.y - a.y * b.x;
    }
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Double2 a = polygon[i] * stretch, b = polygon[(i + 1) % polygon.size()] * stretch;
        const Double2 edge = b - a, to = p * stretch - a;
        const double length = glm::length(edge);
        if (length < 1e-12) continue;
        const double side = (edge.x * to.y - edge.y * to.x) / length;
        depth = std::min(depth, area > 0 ? side : -side);
    }
    return depth;
}

// Compares outline and traced hits over a grid; returns how many points were inside.
int compare(const Object& object, const Camera& camera) {
    SceneMaker maker;
    maker.lambertian(0.5);
    maker.scene.objects = {object};
    SceneArrays arrays;
    flatten(maker.scene, SceneParts::All, arrays);
    const std::vector<Double2> outline = outline_of(object, camera, kAspect, kHeight);
    int inside = 0;
    for (int y = 0; y < 27; ++y) {
        for (int x = 0; x < 48; ++x) {
            const Double2 p((x + 0.5) / 48, (y + 0.5) / 27);
            const double depth = depth_inside(outline, p);
            if (std::abs(depth) < 0.6 / kHeight) continue;  // at the edge itself
            const ViewRay ray = view_ray(camera, kAspect, p.x, p.y);
            const bool hit = static_cast<bool>(pick(arrays, ray.origin, ray.direction, 1e9).object);
            CHECK_MESSAGE(hit == (depth > 0), "point " << p.x << ' ' << p.y << " depth " << depth);
            inside += hit ? 1 : 0;
        }
    }
    return inside;
}

std::vector<Shape> shapes() {
    return {SphereShape{{0.2, 0.1, -0.3}, 0.8},
            XyRectShape{{-1, -0.5}, {1, 0.7}, 0.2},
            XzRectShape{{-1, -1}, {1, 1}, -0.2},
            YzRectShape{{-0.6, -1}, {0.8, 1}, 0.1},
            RectangleShape{},
            BoxShape{{-0.7, -0.4, -0.5}, {0.6, 0.8, 0.5}},
            DiskShape{{0, 0.1, 0}, {0.3, 1, 0.2}, 0.9},
            TriangleShape{}};
}

}  // namespace

TEST_CASE("the outline of every shape holds exactly what rays meet, placed and seen at random") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto vector = [&](double size) {
        return Double3(unit(random), unit(random), unit(random)) * size;
    };
    for (const Shape& shape : shapes()) {
        int inside = 0;
        for (int trial = 0; trial < 12; ++trial) {
            Object object;
            object.id = {1};
            object.material = {1};
            object.shape = shape;
            object.transform.rotation = vector(180);
            object.transform.scale = glm::exp(vector(0.7));
            if (trial % 4 == 3) object.transform.scale.x *= -1;
            object.transform.translation = vector(1);
            Camera camera;
            camera.look_from = glm::normalize(vector(1)) * (1.5 + 3 * std::abs(unit(random)));
            camera.look_at = vector(0.5);
            camera.vertical_fov = 60 + 50 * unit(random);
            inside += compare(object, camera);
        }
        CHECK(inside > 500);
    }
}

TEST_CASE("a floor that reaches behind the camera is cut, not turned inside out") {
    Object floor;
    floor.id = {1};
    floor.material = {1};
    floor.shape = XzRectShape{{-500, -500}, {500, 500}, 0};
    Camera camera;
    camera.look_from = {0, 2, 12};
    camera.look_at = {0, 1.5, 0};
    CHECK(compare(floor, camera) > 200);
    camera.look_at = {0, 3.5, 0};
    compare(floor, camera);
}

TEST_CASE("no outline of what is behind the camera or around it; a near ball fills the picture") {
    Object ball;
    ball.id = {1};
    ball.material = {1};
    ball.shape = SphereShape{{0, 0, 5}, 1};
    Camera camera;
    camera.look_from = {0, 0, 0};
    camera.look_at = {0, 0, -1};
    CHECK(outline_of(ball, camera, kAspect, kHeight).empty());
    ball.shape = SphereShape{{0, 0, 0}, 1};
    CHECK(outline_of(ball, camera, kAspect, kHeight).empty());
    ball.shape = BoxShape{};
    CHECK(outline_of(ball, camera, kAspect, kHeight).empty());
    ball.shape = SphereShape{{0, 0, -1.001}, 1};
    compare(ball, camera);
}
