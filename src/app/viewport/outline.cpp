#include "outline.h"

#include "../fly_camera.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tp {
namespace {

constexpr double kHalfTurn = 3.14159265358979323846;
constexpr double kFrame = 1.25;  // half size of the frame that outlines are cut to; the picture: 1
constexpr double kNear = 1e-6;   // of the distance: what is nearer to the camera's plane is cut

// A point before the camera: x and y in units of the picture's half size times w; w is the depth.
struct Seen {
    double x, y, w;
};
using SeenPolygon = std::vector<Seen>;

struct Projection {
    Double3 origin;
    CameraAxes axes;
    double half_width, half_height;

    Seen operator()(const Double3& p) const {
        const Double3 to = p - origin;
        return {glm::dot(to, axes.right) / half_width, glm::dot(to, axes.up) / half_height,
                glm::dot(to, axes.forward)};
    }
};

// A convex solid: flat faces in world space, or the image of the unit ball.
struct Solid {
    std::vector<std::vector<Double3>> faces;
    std::optional<DoubleMat4> ball;  // object from unit ball
};

// Cuts a polygon to where `inside` is not negative (Sutherland and Hodgman 1974).
template <class Inside>
SeenPolygon cut(const SeenPolygon& polygon, const Inside& inside) {
    SeenPolygon result;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Seen &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = inside(a), db = inside(b);
        if (da >= 0) result.push_back(a);
        if ((da < 0) != (db < 0)) {
            const double t = da / (da - db);
            result.push_back({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.w + (b.w - a.w) * t});
        }
    }
    return result;
}

SeenPolygon cut_to_frame(SeenPolygon p) {
    double scale = 0;
    for (const Seen& s : p)
        scale = std::max(scale, std::abs(s.w));
    p = cut(p, [&](const Seen& s) { return s.w - kNear * scale; });
    p = cut(p, [](const Seen& s) { return kFrame * s.w - s.x; });
    p = cut(p, [](const Seen& s) { return kFrame * s.w + s.x; });
    p = cut(p, [](const Seen& s) { return kFrame * s.w - s.y; });
    return cut(p, [](const Seen& s) { return kFrame * s.w + s.y; });
}

double cross(const Double2& o, const Double2& a, const Double2& b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

// The convex hull (Andrew 1979).
std::vector<Double2> hull(std::vector<Double2> points) {
    std::sort(points.begin(), points.end(), [](const Double2& a, const Double2& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    if (points.size() < 3) return {};
    std::vector<Double2> result;
    for (int side = 0; side < 2; ++side) {
        const size_t start = result.size();
        for (const Double2& p : points) {
            while (result.size() >= start + 2 &&
                   cross(result[result.size() - 2], result.back(), p) <= 0)
                result.pop_back();
            result.push_back(p);
        }
        result.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return result.size() < 3 ? std::vector<Double2>{} : result;
}

std::vector<Double3> circle(const Double3& center, const Double3& u, const Double3& v, int count) {
    std::vector<Double3> points;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * kHalfTurn * i / count;
        points.push_back(center + u * std::cos(angle) + v * std::sin(angle));
    }
    return points;
}

// Two unit vectors across a unit vector.
std::pair<Double3, Double3> across(const Double3& n) {
    const Double3 helper = std::abs(n.x) > 0.9 ? Double3(0, 1, 0) : Double3(1, 0, 0);
    const Double3 u = glm::normalize(glm::cross(helper, n));
    return {u, glm::cross(n, u)};
}

// Corners that a circle needs to stay within a quarter of a pixel of `radius` pixels.
int corners_for(double radius) {
    const double wanted = kHalfTurn / std::acos(1 - std::min(1.0, 0.25 / std::max(radius, 1e-3)));
    return std::isfinite(wanted) ? std::clamp(static_cast<int>(std::ceil(wanted)), 8, 256) : 256;
}

// Tangent of the angle that the round part of a shape spans as seen from the camera, at most.
double seen_radius(const Shape& shape, const DoubleMat4& world, const Camera& camera) {
    Double3 center;
    double radius;
    if (const auto* s = std::get_if<SphereShape>(&shape)) {
        center = s->center;
        radius = std::abs(s->radius);
    } else if (const auto* d = std::get_if<DiskShape>(&shape)) {
        center = d->center;
        radius = std::abs(d->radius);
    } else {
        return 0;
    }
    const double stretch = glm::length(world[0]) + glm::length(world[1]) + glm::length(world[2]);
    const double distance = glm::distance(camera.look_from, Double3(world * Double4(center, 1)));
    return stretch * radius / std::max(distance, 1e-12);
}

// The shapes in their own space.
struct MakeSolid {
    int corners;

    Solid flat(std::vector<Double3> face) const { return {{std::move(face)}, std::nullopt}; }

    Solid operator()(const SphereShape& s) const {
        DoubleMat4 ball(s.radius == 0 ? 1e-12 : std::abs(s.radius));
        ball[3] = Double4(s.center, 1);
        return {{}, ball};
    }
    Solid operator()(const XyRectShape& r) const {
        return flat({{r.low.x, r.low.y, r.k},
                     {r.high.x, r.low.y, r.k},
                     {r.high.x, r.high.y, r.k},
                     {r.low.x, r.high.y, r.k}});
    }
    Solid operator()(const XzRectShape& r) const {
        return flat({{r.low.x, r.k, r.low.y},
                     {r.high.x, r.k, r.low.y},
                     {r.high.x, r.k, r.high.y},
                     {r.low.x, r.k, r.high.y}});
    }
    Solid operator()(const YzRectShape& r) const {
        return flat({{r.k, r.low.x, r.low.y},
                     {r.k, r.high.x, r.low.y},
                     {r.k, r.high.x, r.high.y},
                     {r.k, r.low.x, r.high.y}});
    }
    Solid operator()(const RectangleShape& r) const {
        return flat(
            {r.corner, r.corner + r.edge_u, r.corner + r.edge_u + r.edge_v, r.corner + r.edge_v});
    }
    Solid operator()(const BoxShape& b) const {
        Solid solid;
        for (int axis = 0; axis < 3; ++axis) {
            for (int side = 0; side < 2; ++side) {
                std::vector<Double3> face;
                for (const auto& [u, v] :
                     {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
                    Double3 p;
                    p[axis] = side ? b.high[axis] : b.low[axis];
                    p[(axis + 1) % 3] = u ? b.high[(axis + 1) % 3] : b.low[(axis + 1) % 3];
                    p[(axis + 2) % 3] = v ? b.high[(axis + 2) % 3] : b.low[(axis + 2) % 3];
                    face.push_back(p);
                }
                solid.faces.push_back(face);
            }
        }
        return solid;
    }
    Solid operator()(const DiskShape& d) const {
        const double length = glm::length(d.normal);
        if (!(length > 0)) return {};
        const auto [u, v] = across(d.normal / length);
        return flat(circle(d.center, u * d.radius, v * d.radius, corners));
    }
    Solid operator()(const TriangleShape& t) const { return flat({t.a, t.b, t.c}); }
};

// True if the point is inside the solid, where all of the picture shows it and no outline is seen.
bool is_box_around(const Object& object, const Double3& eye_in_object) {
    const auto* box = std::get_if<BoxShape>(&object.shape);
    if (!box) return false;
    const Double3 low = glm::min(box->low, box->high), high = glm::max(box->low, box->high);
    return glm::all(glm::greaterThan(eye_in_object, low)) &&
           glm::all(glm::lessThan(eye_in_object, high));
}

// The circle where rays from the eye graze the ball, as a face; none from inside.
std::vector<Double3> grazing_circle(const DoubleMat4& world, const Double3& eye, int corners) {
    const Double3 e = Double3(glm::inverse(world) * Double4(eye, 1));
    const double square = glm::dot(e, e);
    if (!(square > 1) || !std::isfinite(square)) return {};
    const auto [u, v] = across(e / std::sqrt(square));
    const double radius = std::sqrt(1 - 1 / square);
    std::vector<Double3> points = circle(e / square, u * radius, v * radius, corners);
    for (Double3& p : points)
        p = Double3(world * Double4(p, 1));
    return points;
}

}  // namespace

std::vector<Double2> outline_of(const Object& object, const Camera& camera, double aspect,
                                double height) {
    const double half = std::tan(camera.vertical_fov * kHalfTurn / 360);
    const Projection project{camera.look_from, axes_of(camera), half * aspect, half};
    const DoubleMat4 world = world_from_object(object.transform);

    const int corners = corners_for(seen_radius(object.shape, world, camera) / half * height / 2);
    Solid solid = std::visit(MakeSolid{corners}, object.shape);
    for (auto& face : solid.faces)
        for (Double3& p : face)
            p = Double3(world * Double4(p, 1));
    if (solid.ball) solid.faces = {grazing_circle(world * *solid.ball, camera.look_from, corners)};
    if (is_box_around(object, Double3(glm::inverse(world) * Double4(camera.look_from, 1))))
        return {};

    std::vector<Double2> points;
    for (const auto& face : solid.faces) {
        SeenPolygon polygon;
        for (const Double3& p : face)
            polygon.push_back(project(p));
        for (const Seen& s : cut_to_frame(polygon))
            points.emplace_back(s.x / s.w * 0.5 + 0.5, 0.5 - s.y / s.w * 0.5);
    }
    return hull(std::move(points));
}

}  // namespace tp
