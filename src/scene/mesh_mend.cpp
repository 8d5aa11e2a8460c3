// Attributes of meshes put in order.
#include <teapath/scene/mesh.h>

#include <cmath>

namespace tp {
namespace {

bool has_direction(Float3 v) {
    const float squared = glm::dot(v, v);
    return squared > 1e-30f && std::isfinite(squared);
}

// Normals of the triangles around each vertex, weighted by area, in double: 1e30 squared fits.
std::vector<Double3> normals_of_triangles(const Mesh& mesh) {
    std::vector<Double3> sums(mesh.positions.size(), Double3(0));
    for (const auto& [a, b, c] : mesh.triangles) {
        const Double3 origin = mesh.positions[a];
        const Double3 normal =
            glm::cross(Double3(mesh.positions[b]) - origin, Double3(mesh.positions[c]) - origin);
        for (const uint32_t vertex : {a, b, c})
            sums[vertex] += normal;
    }
    for (Double3& sum : sums) {
        const double length = glm::length(sum);
        sum = length > 0 && std::isfinite(length) ? sum / length : Double3(0, 0, 1);
    }
    return sums;
}

Float3 any_across(Float3 normal) {
    const Float3 axis = std::abs(normal.x) < 0.5f ? Float3(1, 0, 0) : Float3(0, 1, 0);
    return glm::normalize(glm::cross(normal, axis));
}

void mend_normals(Mesh& mesh) {
    std::vector<Double3> from_triangles;
    for (size_t i = 0; i < mesh.normals.size(); ++i) {
        Float3& normal = mesh.normals[i];
        if (has_direction(normal)) {
            normal = glm::normalize(normal);
            continue;
        }
        if (from_triangles.empty()) from_triangles = normals_of_triangles(mesh);
        normal = from_triangles[i];
    }
}

void mend_tangents(Mesh& mesh) {
    for (size_t i = 0; i < mesh.tangents.size(); ++i) {
        Float4& tangent = mesh.tangents[i];
        const Float3 direction(tangent);
        const float handedness = tangent.w < 0 ? -1.0f : 1.0f;
        const Float3 normal = i < mesh.normals.size() ? mesh.normals[i] : Float3(0, 0, 1);
        tangent = Float4(has_direction(direction) ? glm::normalize(direction) : any_across(normal),
                         handedness);
    }
}

}  // namespace

void mend_attributes(Mesh& mesh) {
    mend_normals(mesh);
    mend_tangents(mesh);
    for (auto& set : mesh.uvs)
        for (Float2& uv : set)
            if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) uv = Float2(0);
    for (Float4& color : mesh.colors)
        for (int i = 0; i < 4; ++i)
            if (!std::isfinite(color[i])) color[i] = 1;
}

}  // namespace tp
