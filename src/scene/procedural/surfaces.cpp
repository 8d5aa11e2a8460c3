#include "surfaces.h"

#include <algorithm>
#include <cmath>

namespace tp {
namespace {

constexpr double kPiDouble = 3.14159265358979323846;

Double3 normal_at(const SurfaceFunction& surface, double u, double v) {
    constexpr double kStep = 1e-4;
    for (const double inwards : {0.0, 2e-3, 2e-2}) {
        // At a pole the derivative vanishes: look a little beside it.
        const double w = v + inwards * (v < 0.5 ? 1 : -1);
        const double low = std::max(w - kStep, 0.0), high = std::min(w + kStep, 1.0);
        const Double3 du = surface(u + kStep, w) - surface(u - kStep, w);
        const Double3 dv = surface(u, high) - surface(u, low);
        const Double3 n = glm::cross(du, dv);
        const double size = glm::length(n);
        if (size > 1e-6 * (glm::length(du) + glm::length(dv)) * glm::length(dv)) return n / size;
    }
    return {0, 1, 0};
}

}  // namespace

void add_surface(Mesh& mesh, int columns, int rows, const SurfaceFunction& surface) {
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    if (mesh.uvs.empty()) mesh.uvs.emplace_back();
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const double u = static_cast<double>(i) / columns, v = static_cast<double>(j) / rows;
            mesh.positions.push_back(Float3(surface(u, v)));
            mesh.normals.push_back(Float3(normal_at(surface, u, v)));
            mesh.uvs[0].push_back(Float2(u, 1 - v));
        }
    const auto at = [&](int i, int j) {
        return first + static_cast<uint32_t>(j * (columns + 1) + i);
    };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
}

Double3 bezier(const std::vector<Double3>& points, double t) {
    const auto pieces = static_cast<double>((points.size() - 1) / 3);
    const double place = std::clamp(t, 0.0, 1.0) * pieces;
    const double piece = std::min(std::floor(place), pieces - 1);
    const double s = place - piece, r = 1 - s;
    const Double3* p = points.data() + 3 * static_cast<size_t>(piece);
    return p[0] * (r * r * r) + p[1] * (3 * r * r * s) + p[2] * (3 * r * s * s) +
           p[3] * (s * s * s);
}

void add_revolution(Mesh& mesh, int around, int along, const std::vector<Double3>& profile) {
    add_surface(mesh, around, along, [&](double u, double v) {
        const Double3 p = bezier(profile, v);
        const double angle = -2 * kPiDouble * u;
        return Double3(p.x * std::cos(angle), p.y, p.x * std::sin(angle));
    });
}

void add_tube(Mesh& mesh, int around, int along, const CurveFunction& curve,
              const std::function<double(double)>& radius, bool closed) {
    // Frames that do not turn about the curve, by two reflections a step.
    constexpr double kStep = 1e-4;
    const auto tangent = [&](double t) {
        return glm::normalize(curve(t + kStep) - curve(t - kStep));
    };
    const int steps = along * 4;
    std::vector<Double3> sides;
    Double3 forward = tangent(0);
    const Double3 aside = std::abs(forward.y) < 0.9 ? Double3(0, 1, 0) : Double3(1, 0, 0);
    Double3 side = glm::normalize(glm::cross(forward, aside));
    for (int k = 0; k <= steps; ++k) {
        sides.push_back(side);
        const double t = static_cast<double>(k) / steps, next = t + 1.0 / steps;
        const Double3 step = curve(next) - curve(t);
        const double length2 = glm::dot(step, step);
        if (!(length2 > 0)) continue;
        const Double3 reflected = side - step * (2 * glm::dot(step, side) / length2);
        const Double3 turned = forward - step * (2 * glm::dot(step, forward) / length2);
        forward = tangent(next);
        const Double3 rest = forward - turned;
        const double rest2 = glm::dot(rest, rest);
        side = rest2 > 0 ? reflected - rest * (2 * glm::dot(rest, reflected) / rest2) : reflected;
    }
    // A closed curve comes back turned: the turn is spread over its length.
    double turn = 0;
    if (closed) {
        const Double3 f = tangent(0), across = glm::cross(f, sides.front());
        turn = -std::atan2(glm::dot(sides.back(), across), glm::dot(sides.back(), sides.front()));
    }
    const auto side_at = [&](double t, const Double3& f) {
        const double wrapped = closed ? t - std::floor(t) : std::clamp(t, 0.0, 1.0);
        const auto k = static_cast<size_t>(std::min(wrapped * steps, steps - 1e-9));
        const Double3 s =
            glm::mix(sides[k], sides[k + 1], wrapped * steps - static_cast<double>(k));
        return glm::normalize(s - f * glm::dot(s, f));
    };
    add_surface(mesh, around, along, [&](double u, double v) {
        const Double3 f = tangent(v), x = side_at(v, f), y = glm::cross(f, x);
        const double wrapped = closed ? v - std::floor(v) : v;
        const double angle = 2 * kPiDouble * u + turn * wrapped;
        return curve(v) + (x * std::cos(angle) + y * std::sin(angle)) * radius(v);
    });
}

void add_cap(Mesh& mesh, int around, Double3 center, Double3 normal, double radius) {
    const Double3 aside = std::abs(normal.y) < 0.9 ? Double3(0, 1, 0) : Double3(1, 0, 0);
    const Double3 x = glm::normalize(glm::cross(normal, aside)), y = glm::cross(normal, x);
    add_surface(mesh, around, 1, [&](double u, double v) {
        const double angle = -2 * kPiDouble * u;
        return center + (x * std::cos(angle) + y * std::sin(angle)) * (radius * (1 - v));
    });
}

}  // namespace tp
