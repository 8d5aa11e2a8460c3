// Meshes for tests, made in code.
#pragma once

#include <teapath/scene/object.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace tp::test {

/// The box [-1, 1]^3, normals outwards, 12 triangles, flat.
inline Mesh box_mesh() {
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.positions.push_back({corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1});
    const uint32_t faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& f : faces) {
        mesh.triangles.push_back({f[0], f[1], f[2]});
        mesh.triangles.push_back({f[0], f[2], f[3]});
    }
    return mesh;
}

/// The square [-1, 1]^2 in z = 0 with its front to +z and the whole unit square of uv, upright.
inline Mesh square_mesh() {
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.uvs = {{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

/// An icosahedron of radius 1, each triangle split into four `levels` times: 20 * 4^levels
/// triangles. Vertices move outwards by up to `jitter`; normals are those of the sphere.
inline Mesh ball_mesh(int levels, double jitter = 0) {
    const float g = (1 + std::sqrt(5.0f)) / 2;
    Mesh mesh;
    mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
        const auto middle = [&](uint32_t a, uint32_t b) {
            const auto [entry, is_new] = middles.try_emplace(
                std::minmax(a, b), static_cast<uint32_t>(mesh.positions.size()));
            if (is_new) mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]) * 0.5f);
            return entry->second;
        };
        std::vector<std::array<uint32_t, 3>> split;
        for (const auto& t : mesh.triangles) {
            const uint32_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]),
                           ca = middle(t[2], t[0]);
            split.push_back({t[0], ab, ca});
            split.push_back({t[1], bc, ab});
            split.push_back({t[2], ca, bc});
            split.push_back({ab, bc, ca});
        }
        mesh.triangles = std::move(split);
    }
    std::mt19937 random(5);
    std::uniform_real_distribution<float> outwards(0, static_cast<float>(jitter));
    for (Float3& p : mesh.positions) {
        const Float3 n = glm::normalize(p);
        mesh.normals.push_back(n);
        p = n * (1 + outwards(random));
    }
    return mesh;
}

inline MeshShape mesh_shape(std::shared_ptr<const Mesh> mesh) {
    MeshShape shape;
    shape.file = {"made by the test", std::move(mesh)};
    return shape;
}
inline MeshShape mesh_shape(Mesh mesh) {
    return mesh_shape(share(std::move(mesh)));
}

}  // namespace tp::test
