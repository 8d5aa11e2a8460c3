#include "makers.h"
#include "surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tp {
namespace {

constexpr double kPiDouble = 3.14159265358979323846;

// A convex polygon with flat edges: its corners belong to it alone.
void add_facet(Mesh& mesh, const std::vector<Double3>& corners) {
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (const Double3& c : corners)
        mesh.positions.push_back(Float3(c));
    for (uint32_t i = 2; i < corners.size(); ++i)
        mesh.triangles.push_back({first, first + i - 1, first + i});
}

// A side of a rounded box: a grid over the cube's face, pulled onto the rounded surface.
void add_rounded_side(Mesh& mesh, int axis, double sign, Double3 half, double radius, int detail) {
    // Most of the grid's lines lie in the round edges.
    std::vector<double> lines;
    for (int i = 0; i <= detail; ++i)
        lines.push_back(-1 + 0.5 * i / detail);
    for (int i = 0; i <= detail; ++i)
        lines.push_back(0.5 + 0.5 * i / detail);
    const int n = static_cast<int>(lines.size()) - 1;
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    // A line's place on the flat part's end, and the angle that it stands for beyond it.
    const auto split = [&](double line, double flat, double& base) {
        base = line < -0.5 || line > 0.5 ? std::copysign(flat, line) : flat * line / 0.5;
        return std::abs(line) > 0.5 ? std::copysign((std::abs(line) - 0.5) * kPiDouble / 2, line)
                                    : 0.0;
    };
    const Double3 inner = half - Double3(radius);
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            Double3 base(0), direction(0);
            const double a = split(lines[static_cast<size_t>(i)], inner[x], base[x]);
            const double b = split(lines[static_cast<size_t>(j)], inner[y], base[y]);
            base[axis] = inner[axis] * sign;
            // The tangent reaches 1 at the edge, where the next side begins.
            direction[x] = std::tan(a);
            direction[y] = std::tan(b);
            direction[axis] = sign;
            direction = glm::normalize(direction);
            mesh.positions.push_back(Float3(base + direction * radius));
            mesh.normals.push_back(Float3(direction));
            mesh.uvs[0].push_back(
                Float2(static_cast<double>(i) / n, 1 - static_cast<double>(j) / n));
        }
    const auto at = [&](int i, int j) { return first + static_cast<uint32_t>(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            std::array<uint32_t, 4> q = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
            if (sign < 0) std::swap(q[1], q[3]);
            mesh.triangles.push_back({q[0], q[1], q[2]});
            mesh.triangles.push_back({q[0], q[2], q[3]});
        }
}

}  // namespace

Mesh make_knot(ProceduralParameters& parameters) {
    const int p = parameters.whole("p", 2, 1, 64), q = parameters.whole("q", 3, 0, 64);
    const double tube = parameters.number("tube", 0.25, 1e-3, 1);
    const int detail = parameters.whole("detail", 256, 8, 4096);
    Mesh mesh;
    add_tube(
        mesh, std::max(detail / 8, 6), detail,
        [&](double t) {
            const double a = 2 * kPiDouble * p * t, b = 2 * kPiDouble * q * t;
            const double r = 1 + 0.45 * std::cos(b);
            return Double3(r * std::cos(a), 0.45 * std::sin(b), -r * std::sin(a));
        },
        [&](double) { return tube; }, true);
    return mesh;
}

Mesh make_torus(ProceduralParameters& p) {
    const double tube = p.number("tube", 0.25, 1e-4, 1);
    const int detail = p.whole("detail", 96, 6, 4096);
    Mesh mesh;
    add_surface(mesh, detail / 2, detail, [&](double u, double v) {
        const double around = 2 * kPiDouble * v, across = 2 * kPiDouble * u;
        const double r = 1 + tube * std::cos(across);
        return Double3(r * std::cos(around), tube * std::sin(across), r * std::sin(around));
    });
    return mesh;
}

Mesh make_rounded_box(ProceduralParameters& p) {
    const Double3 half = Double3(p.number("x", 1, 1e-3, 1e3), p.number("y", 1, 1e-3, 1e3),
                                 p.number("z", 1, 1e-3, 1e3)) *
                         0.5;
    const double least = std::min({half.x, half.y, half.z});
    const double radius = p.number("radius", std::min(0.1, least), 1e-6, least);
    const int detail = p.whole("detail", 8, 1, 256);
    Mesh mesh;
    mesh.uvs.emplace_back();
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0})
            add_rounded_side(mesh, axis, sign, half, radius, detail);
    return mesh;
}

// A round brilliant after Tolkowsky's proportions (1919): 57 facets, girdle of diameter 1.
Mesh make_gem(ProceduralParameters&) {
    const double girdle = 0.5, table = 0.53 / 2, crown = 0.162, pavilion = 0.431;
    const double thickness = 0.015;
    const auto ring = [](double radius, double height, double eighths) {
        const double angle = eighths * kPiDouble / 4;
        return Double3(radius * std::cos(angle), height, radius * std::sin(angle));
    };
    const double star = 0.365, star_height = thickness + crown * 0.62;
    const double lower = 0.16, lower_height = -thickness - pavilion * 0.68;
    Mesh mesh;
    std::vector<Double3> top;
    for (int i = 0; i < 8; ++i)
        top.push_back(ring(table, thickness + crown, -i));
    add_facet(mesh, top);
    const Double3 culet(0, -thickness - pavilion, 0);
    for (int i = 0; i < 8; ++i) {
        const Double3 t0 = ring(table, thickness + crown, i);
        const Double3 t1 = ring(table, thickness + crown, i + 1);
        const Double3 s0 = ring(star, star_height, i - 0.5), s1 = ring(star, star_height, i + 0.5);
        const Double3 g0 = ring(girdle, thickness, i), g1 = ring(girdle, thickness, i + 0.5),
                      g2 = ring(girdle, thickness, i + 1);
        add_facet(mesh, {t0, t1, s1});      // star
        add_facet(mesh, {t0, s1, g0, s0});  // kite
        add_facet(mesh, {s1, g1, g0});      // upper girdle
        add_facet(mesh, {s1, g2, g1});
        // The girdle.
        const Double3 h0 = ring(girdle, -thickness, i), h1 = ring(girdle, -thickness, i + 0.5),
                      h2 = ring(girdle, -thickness, i + 1);
        add_facet(mesh, {g0, g1, h1, h0});
        add_facet(mesh, {g1, g2, h2, h1});
        // The pavilion: lower girdle facets and mains.
        const Double3 l0 = ring(lower, lower_height, i - 0.5),
                      l1 = ring(lower, lower_height, i + 0.5);
        add_facet(mesh, {h0, h1, l1});
        add_facet(mesh, {h1, h2, l1});
        add_facet(mesh, {h0, l1, culet, l0});
    }
    return mesh;
}

}  // namespace tp
