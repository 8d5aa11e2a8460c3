#include <teapath/core/parallel.h>
#include <teapath/scene/deform.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace tp {
namespace {

constexpr int64_t kGrain = 4096;  // vertices of a chunk

template <class T>
size_t bytes_of_list(const std::vector<T>& list) {
    return list.size() * sizeof(T);
}

void add_scaled(const std::vector<Float3>& deltas, float weight, size_t v,
                std::vector<Float3>& values) {
    if (!deltas.empty() && !values.empty()) values[v] += deltas[v] * weight;
}

// Acts on single vertices, so that threads share a mesh.
class Deformer {
public:
    Deformer(const DeformableMesh& deformable, const std::vector<double>& weights,
             const std::vector<DoubleMat4>& joints, Mesh& mesh)
        : deformable_(deformable), weights_(weights), joints_(joints), mesh_(mesh) {}

    bool is_skinned() const { return !joints_.empty() && !deformable_.skin.joints.empty(); }

    void morph(size_t v) {
        const size_t count = std::min(weights_.size(), deformable_.targets.size());
        for (size_t t = 0; t < count; ++t) {
            const auto weight = static_cast<float>(weights_[t]);
            if (weight == 0) continue;
            const MorphTarget& target = deformable_.targets[t];
            add_scaled(target.positions, weight, v, mesh_.positions);
            add_scaled(target.normals, weight, v, mesh_.normals);
            if (target.tangents.empty() || mesh_.tangents.empty()) continue;
            mesh_.tangents[v] += Float4(target.tangents[v] * weight, 0);
        }
    }

    // Linear blend skinning. Returns true if the vertex is mirrored.
    bool skin(size_t v) {
        const DoubleMat4 blend = blend_of(v);
        mesh_.positions[v] = Float3(Double3(blend * Double4(Double3(mesh_.positions[v]), 1)));
        const DoubleMat3 linear(blend);
        const double determinant = glm::determinant(linear);
        if (!mesh_.normals.empty()) {
            const DoubleMat3 of_normals =
                determinant != 0 ? glm::transpose(glm::inverse(linear)) : linear;
            mesh_.normals[v] = Float3(of_normals * Double3(mesh_.normals[v]));
        }
        if (!mesh_.tangents.empty())
            mesh_.tangents[v] =
                Float4(Float3(linear * Double3(mesh_.tangents[v])), mesh_.tangents[v].w);
        return determinant < 0;
    }

private:
    DoubleMat4 blend_of(size_t v) const {
        DoubleMat4 blend(0);
        double sum = 0;
        const SkinWeights& skin = deformable_.skin;
        for (size_t set = 0; set < skin.joints.size(); ++set)
            for (int k = 0; k < 4; ++k) {
                const auto weight = static_cast<double>(skin.weights[set][v][k]);
                if (!(weight > 0)) continue;
                blend += joints_[static_cast<size_t>(skin.joints[set][v][k])] * weight;
                sum += weight;
            }
        if (sum > 0) return blend * (1 / sum);
        return joints_[0];
    }

    const DeformableMesh& deformable_;
    const std::vector<double>& weights_;
    const std::vector<DoubleMat4>& joints_;
    Mesh& mesh_;
};

}  // namespace

size_t DeformableMesh::bytes() const {
    size_t sum = bytes_of(mesh);
    for (const MorphTarget& target : targets)
        sum += bytes_of_list(target.positions) + bytes_of_list(target.normals) +
               bytes_of_list(target.tangents);
    for (const auto& set : skin.joints)
        sum += 2 * bytes_of_list(set);
    return sum;
}

std::string problem_of(const DeformableMesh& deformable, size_t joints) {
    const size_t count = deformable.mesh.positions.size();
    for (const MorphTarget& target : deformable.targets)
        for (const auto* list : {&target.positions, &target.normals, &target.tangents})
            if (!list->empty() && list->size() != count)
                return fmt::format("a morph target has {} vertices of {}", list->size(), count);
    const SkinWeights& skin = deformable.skin;
    for (size_t set = 0; set < skin.joints.size(); ++set)
        for (size_t v = 0; v < count; ++v)
            for (int k = 0; k < 4; ++k) {
                const float joint = skin.joints[set][v][k];
                if (!(skin.weights[set][v][k] > 0)) continue;
                if (!(joint >= 0 && static_cast<double>(joint) < static_cast<double>(joints)))
                    return fmt::format("joint {} is beyond the {} of the skin", joint, joints);
            }
    return {};
}

Mesh deformed(const DeformableMesh& deformable, const std::vector<double>& weights,
              const std::vector<DoubleMat4>& joints, bool parallel) {
    Mesh mesh = deformable.mesh;
    const auto count = static_cast<int64_t>(mesh.positions.size());
    std::vector<char> mirrored(mesh.positions.size());
    Deformer deformer(deformable, weights, joints, mesh);
    const auto act = [&](int64_t first, int64_t last) {
        for (auto v = static_cast<size_t>(first); v < static_cast<size_t>(last); ++v) {
            deformer.morph(v);
            if (deformer.is_skinned()) mirrored[v] = deformer.skin(v);
        }
    };
    if (parallel)
        parallel_for(count, kGrain, act);
    else
        act(0, count);

    // What is mirrored gets its fronts back.
    if (2 * std::count(mirrored.begin(), mirrored.end(), char{1}) > count)
        for (auto& triangle : mesh.triangles)
            std::swap(triangle[1], triangle[2]);
    mend_attributes(mesh);
    return mesh;
}

}  // namespace tp
