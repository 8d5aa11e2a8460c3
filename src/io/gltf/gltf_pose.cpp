#include "gltf_pose.h"

#include "gltf_accessor.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace tp {
namespace {

[[noreturn]] void fail(const std::string& what, const std::string& where) {
    throw Error(ErrorKind::Input, what, where, "export the model again");
}

void add_scaled(const GltfDocument& document, const std::map<std::string, int>& target,
                const char* name, double weight, const std::string& where,
                std::vector<Float3>& values) {
    const auto found = target.find(name);
    if (found == target.end() || values.empty()) return;
    const std::vector<Float3> deltas = read_vectors<Float3>(document, found->second, where);
    if (deltas.size() != values.size())
        fail(fmt::format("a morph target has {} vertices of {}", deltas.size(), values.size()),
             where);
    for (size_t i = 0; i < values.size(); ++i)
        values[i] += deltas[i] * static_cast<float>(weight);
}

}  // namespace

MeshUse use_of_mesh(const GltfDocument& document, size_t index) {
    const tinygltf::Node& node = document.model.nodes[index];
    const auto& meshes = document.model.meshes;
    MeshUse use;
    use.mesh = static_cast<size_t>(node.mesh);
    if (node.mesh < 0 || use.mesh >= meshes.size())
        fail(fmt::format("there is no mesh {}", node.mesh), document.place("nodes", index));
    use.skin = std::max(node.skin, -1);
    if (use.skin >= static_cast<int>(document.model.skins.size()))
        fail(fmt::format("there is no skin {}", node.skin), document.place("nodes", index));
    use.weights = node.weights.empty() ? meshes[use.mesh].weights : node.weights;
    if (std::all_of(use.weights.begin(), use.weights.end(), [](double w) { return w == 0; }))
        use.weights.clear();
    return use;
}

std::vector<DoubleMat4> joint_matrices(const GltfDocument& document, int index,
                                       const std::vector<GltfNode>& nodes) {
    const tinygltf::Skin& skin = document.model.skins.at(static_cast<size_t>(index));
    const std::string where = document.place("skins", static_cast<size_t>(index));
    std::unordered_map<int, const DoubleMat4*> worlds;
    for (const GltfNode& node : nodes)
        worlds[static_cast<int>(node.index)] = &node.world;
    std::vector<float> inverse_bind;
    if (skin.inverseBindMatrices >= 0) {
        const auto& accessor = checked_accessor(document, skin.inverseBindMatrices, where);
        if (accessor.type != TINYGLTF_TYPE_MAT4 || accessor.count < skin.joints.size())
            fail("there are fewer matrices than joints", where);
        inverse_bind = read_floats(document, skin.inverseBindMatrices, where);
    }
    std::vector<DoubleMat4> matrices;
    for (size_t j = 0; j < skin.joints.size(); ++j) {
        const auto world = worlds.find(skin.joints[j]);
        if (world == worlds.end()) return {};
        DoubleMat4 bind(1);
        for (size_t k = 0; k < 16 && !inverse_bind.empty(); ++k)
            bind[static_cast<int>(k / 4)][static_cast<int>(k % 4)] = inverse_bind[j * 16 + k];
        matrices.push_back(*world->second * bind);
    }
    return matrices;
}

void apply_morph(const GltfDocument& document, const tinygltf::Primitive& primitive,
                 const std::vector<double>& weights, const std::string& where, Mesh& mesh) {
    const size_t count = std::min(weights.size(), primitive.targets.size());
    for (size_t t = 0; t < count; ++t) {
        if (weights[t] == 0) continue;
        const auto& target = primitive.targets[t];
        add_scaled(document, target, "POSITION", weights[t], where, mesh.positions);
        add_scaled(document, target, "NORMAL", weights[t], where, mesh.normals);
    }
}

void apply_skin(const SkinWeights& skin, const std::vector<DoubleMat4>& joints,
                const std::string& where, Mesh& mesh) {
    if (joints.empty() || skin.joints.empty()) return;
    double turned = 0;  // what is mirrored gets its fronts back
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
        DoubleMat4 blend(0);
        double sum = 0;
        for (size_t set = 0; set < skin.joints.size(); ++set)
            for (int k = 0; k < 4; ++k) {
                const double weight = skin.weights[set][v][k];
                if (!(weight > 0)) continue;
                const double joint = skin.joints[set][v][k];
                if (!(joint >= 0 && joint < static_cast<double>(joints.size())))
                    fail(fmt::format("joint {} is beyond the {} of the skin", joint, joints.size()),
                         where);
                blend += joints[static_cast<size_t>(joint)] * weight;
                sum += weight;
            }
        if (sum > 0)
            blend *= 1 / sum;
        else
            blend = joints[0];
        mesh.positions[v] = Float3(Double3(blend * Double4(Double3(mesh.positions[v]), 1)));
        const DoubleMat3 linear(blend);
        const double determinant = glm::determinant(linear);
        turned += determinant < 0 ? -1 : 1;
        if (!mesh.normals.empty()) {
            const DoubleMat3 of_normals =
                determinant != 0 ? glm::transpose(glm::inverse(linear)) : linear;
            mesh.normals[v] = Float3(of_normals * Double3(mesh.normals[v]));
        }
        if (!mesh.tangents.empty())
            mesh.tangents[v] =
                Float4(Float3(linear * Double3(mesh.tangents[v])), mesh.tangents[v].w);
    }
    if (turned < 0)
        for (auto& triangle : mesh.triangles)
            std::swap(triangle[1], triangle[2]);
}

}  // namespace tp
