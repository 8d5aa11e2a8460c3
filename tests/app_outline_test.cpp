// The forms that the outline is drawn from against tracing: computed here as the shaders do, a
// point of the picture is in the form exactly where its ray meets the object.
#include "app/fly_camera.h"
#include "app/viewport/outline.h"
#include "app/viewport/projection.h"
#include "support/scene_maker.h"

#include <teapath/device/pick.h>

#include <cmath>
#include <random>

using namespace tp;
using namespace tp::test;

namespace {

constexpr double kAspect = 16.0 / 9;

// The least t > 0 where a ray in the form's space meets it, as in selection.frag; 0 = nowhere.
// `size` is 1, or nearly: whether a form a little larger or smaller is met as well.
double meets(OutlineForm form, const Double3& origin, const Double3& direction, double size) {
    if (form == OutlineForm::Ball) {
        const double a = glm::dot(direction, direction), b = glm::dot(origin, direction);
        const double square = b * b - a * (glm::dot(origin, origin) - size * size);
        if (square < 0) return 0;
        const double near = (-b - std::sqrt(square)) / a, far = (-b + std::sqrt(square)) / a;
        return near > 0 ? near : std::max(0.0, far);
    }
    if (form == OutlineForm::Box) {
        Double3 low = (Double3(-size) - origin) / direction,
                high = (Double3(size) - origin) / direction;
        for (int i = 0; i < 3; ++i)
            if (low[i] > high[i]) std::swap(low[i], high[i]);
        const double enter = std::max({low.x, low.y, low.z}),
                     leave = std::min({high.x, high.y, high.z});
        if (enter > leave) return 0;
        return enter > 0 ? enter : std::max(0.0, leave);
    }
    const double t = -origin.z / direction.z;
    if (!(t > 0)) return 0;
    const Double3 p = origin + direction * t;
    const bool inside = form == OutlineForm::Disk ? glm::length(Double2(p)) < size
                        : form == OutlineForm::Triangle
                            ? p.x > -size && p.y > -size && p.x + p.y < 2 * (size - 1)
                            : std::max(std::abs(p.x), std::abs(p.y)) < size;
    return inside ? t : 0;
}

// Compares form and traced hits over a grid; returns how many points were inside.
int compare(const Object& object, const Camera& camera) {
    SceneMaker maker;
    maker.lambertian(0.5);
    maker.scene.objects = {object};
    SceneArrays arrays;
    flatten(maker.scene, SceneParts::All, arrays);
    OutlinePart part = outline_part(object);
    // Flat forms get a normal, so that the way back exists.
    if (part.form >= OutlineForm::Rectangle)
        part.world_from_unit[2] = Double4(
            glm::cross(Double3(part.world_from_unit[0]), Double3(part.world_from_unit[1])), 0);
    const DoubleMat4 unit_from_world = glm::inverse(part.world_from_unit);
    int inside = 0;
    for (int y = 0; y < 27; ++y) {
        for (int x = 0; x < 48; ++x) {
            const ViewRay ray = view_ray(camera, kAspect, (x + 0.5) / 48, (y + 0.5) / 27);
            const Double3 origin(unit_from_world * Double4(ray.origin, 1));
            const Double3 direction(unit_from_world * Double4(ray.direction, 0));
            const bool met = meets(part.form, origin, direction, 1) > 0;
            // At the edge itself rounding decides.
            const double margin = 1e-4;
            if (met != (meets(part.form, origin, direction, 1 + margin) > 0) ||
                met != (meets(part.form, origin, direction, 1 - margin) > 0))
                continue;
            const bool hit = static_cast<bool>(pick(arrays, ray.origin, ray.direction, 1e9).object);
            CHECK_MESSAGE(hit == met, "point " << x << ' ' << y);
            inside += hit ? 1 : 0;
        }
    }
    return inside;
}

std::vector<Shape> shapes() {
    return {SphereShape{{0.2, 0.1, -0.3}, 0.8},
            SphereShape{{0.2, 0.1, -0.3}, -0.8},
            XyRectShape{{-1, -0.5}, {1, 0.7}, 0.2},
            XzRectShape{{-1, -1}, {1, 1}, -0.2},
            YzRectShape{{-0.6, -1}, {0.8, 1}, 0.1},
            RectangleShape{},
            BoxShape{{-0.7, -0.4, -0.5}, {0.6, 0.8, 0.5}},
            DiskShape{{0, 0.1, 0}, {0.3, 1, 0.2}, 0.9},
            TriangleShape{}};
}

}  // namespace

TEST_CASE("the outline's form of every shape is where rays meet it, placed and seen at random") {
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

TEST_CASE("clip space of the outline is that of the picture's rays") {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int trial = 0; trial < 200; ++trial) {
        Camera camera;
        camera.look_from = Double3(unit(random), unit(random), unit(random)) * 10.0;
        camera.look_at = Double3(unit(random), unit(random), unit(random));
        camera.vertical_fov = 1 + 119 * std::abs(unit(random));
        camera.film_height = 1 + 5 * std::abs(unit(random));
        camera.shift = Double2(unit(random), unit(random)) * 0.5;
        if (trial % 2 == 1) camera.projection = ProjectionKind::Orthographic;
        const Double2 p(std::abs(unit(random)), std::abs(unit(random)));
        const ViewRay ray = view_ray(camera, kAspect, p.x, p.y);
        const double t = 0.1 + 5 * std::abs(unit(random));
        const Double3 point = ray.origin + ray.direction * t;
        const Double4 clip = clip_from_world(camera, kAspect) * Double4(point, 1);
        const double depth = glm::dot(point - camera.look_from, axes_of(camera).forward);
        CHECK(clip.x / clip.w == doctest::Approx(2 * p.x - 1).epsilon(2e-4));
        CHECK(clip.y / clip.w == doctest::Approx(1 - 2 * p.y).epsilon(2e-4));
        CHECK(clip.z == doctest::Approx(depth));
        CHECK(clip.w == doctest::Approx(trial % 2 == 1 ? 1 : depth));

        const FilmPlane film = film_plane(camera, kAspect);
        const Double3 on_film = film.corner + film.right * p.x + film.down * p.y;
        const Double3 start = trial % 2 == 1 ? ray.origin - camera.look_from : ray.direction;
        const Double3 wanted = trial % 2 == 1 ? on_film : glm::normalize(on_film);
        CHECK(glm::distance(start, wanted) < 1e-5);
    }
}

TEST_CASE(
    "rays of the picture begin and end at the clip planes, and miss beside a fisheye's film") {
    Camera camera;
    camera.look_from = {0, 0, 5};
    camera.near_clip = 2;
    camera.far_clip = 7;
    ViewRay ray = view_ray(camera, 1, 0.9, 0.2);
    CHECK(ray.origin.z == doctest::Approx(3));
    CHECK((ray.origin + ray.direction * ray.t_max).z == doctest::Approx(-2));
    camera.projection = ProjectionKind::Fisheye;
    camera.vertical_fov = 180;
    CHECK(view_ray(camera, 1, 0.5, 0.02).t_max > 0);
    CHECK(view_ray(camera, 1, 0.02, 0.02).t_max == 0);
    CHECK_FALSE(keeps_lines_straight(camera));
    CHECK(keeps_lines_straight(Camera{}));
}

TEST_CASE("the wheel and framing know the projection") {
    Camera camera;
    camera.projection = ProjectionKind::Orthographic;
    CHECK(widened(camera, -1).film_height < camera.film_height);
    CHECK(widened(widened(camera, -1), 1).film_height == doctest::Approx(camera.film_height));
    const Camera framed = frame(camera, {1, 2, 3}, 5, 0.5);
    CHECK(framed.film_height == doctest::Approx(24));
    CHECK(framed.look_at == Double3(1, 2, 3));
    CHECK(glm::distance(framed.look_from, framed.look_at) >= 10);
    CHECK(seen_height(camera, 100) == camera.film_height);

    camera.projection = ProjectionKind::Fisheye;
    camera.vertical_fov = 180;
    CHECK(widened(camera, 5).vertical_fov == 185);
    CHECK(seen_height(camera, 1) > 0);
    camera.projection = ProjectionKind::Equirectangular;
    CHECK(widened(camera, 5) == camera);
}

TEST_CASE(
    "meshes are their own outlines, as many as there are triangles for; the others are boxes") {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 4}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
    Object object;
    object.shape = MeshShape{{"a.ply", share(mesh)}, {}};
    object.transform.translation = {1, 2, 3};
    Object hidden = object, ball;
    hidden.visible = false;
    ball.shape = SphereShape{};
    const std::vector<const Object*> objects = {&object, &hidden, &ball, &object, &object};
    const std::vector<OutlinePart> parts = outline_parts(objects, 5);
    REQUIRE(parts.size() == 4);
    CHECK(parts[0].form == OutlineForm::Mesh);
    CHECK(parts[1].form == OutlineForm::Ball);
    CHECK(parts[2].form == OutlineForm::Mesh);
    CHECK(parts[3].form == OutlineForm::Box);
    CHECK(parts[0].mesh == std::get<MeshShape>(object.shape).file.mesh);
    CHECK(Double3(parts[0].world_from_unit * Double4(0, 3, 4, 1)) == Double3(1, 5, 7));
    // The box has the mesh's corners at those of its cube.
    CHECK(Double3(parts[3].world_from_unit * Double4(-1, -1, -1, 1)) == Double3(1, 2, 3));
    CHECK(Double3(parts[3].world_from_unit * Double4(1, 1, 1, 1)) == Double3(3, 5, 7));
}
