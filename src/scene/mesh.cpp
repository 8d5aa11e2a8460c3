#include <teapath/scene/mesh.h>

#include <fmt/format.h>

#include <cmath>

namespace tp {
namespace {

template <class T>
size_t bytes(const std::vector<T>& list) {
    return list.size() * sizeof(T);
}

template <class Vector>
bool all_finite(const std::vector<Vector>& list) {
    for (const Vector& v : list)
        for (int i = 0; i < Vector::length(); ++i)
            if (!std::isfinite(v[i])) return false;
    return true;
}

template <class T>
std::string problem_of_list(const char* what, const std::vector<T>& list, size_t vertices) {
    if (!list.empty() && list.size() != vertices)
        return fmt::format("{} {} for {} vertices", list.size(), what, vertices);
    if (!all_finite(list)) return fmt::format("the {} are not all finite numbers", what);
    return {};
}

}  // namespace

size_t bytes_of(const Mesh& mesh) {
    size_t sum = bytes(mesh.positions) + bytes(mesh.triangles) + bytes(mesh.normals) +
                 bytes(mesh.tangents) + bytes(mesh.colors);
    for (const auto& set : mesh.uvs)
        sum += bytes(set);
    return sum;
}

std::shared_ptr<const Mesh> share(Mesh mesh) {
    if (!mesh.positions.empty()) mesh.low = mesh.high = mesh.positions.front();
    for (const Float3& p : mesh.positions) {
        mesh.low = glm::min(mesh.low, p);
        mesh.high = glm::max(mesh.high, p);
    }
    return std::make_shared<const Mesh>(std::move(mesh));
}

std::string problem_of(const Mesh& mesh) {
    const size_t vertices = mesh.positions.size();
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const uint32_t index : mesh.triangles[t])
            if (index >= vertices)
                return fmt::format("index {} of triangle {} is beyond the {} vertices", index, t,
                                   vertices);
    std::string problem = problem_of_list("positions", mesh.positions, vertices);
    if (problem.empty()) problem = problem_of_list("normals", mesh.normals, vertices);
    if (problem.empty()) problem = problem_of_list("tangents", mesh.tangents, vertices);
    if (problem.empty()) problem = problem_of_list("colours", mesh.colors, vertices);
    for (const auto& set : mesh.uvs)
        if (problem.empty()) problem = problem_of_list("texture coordinates", set, vertices);
    return problem;
}

}  // namespace tp
