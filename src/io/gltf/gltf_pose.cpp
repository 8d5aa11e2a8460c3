#include "gltf_pose.h"

#include "gltf_accessor.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

namespace tp {
namespace {

[[noreturn]] void fail(const std::string& what, const std::string& where) {
    throw Error(ErrorKind::Input, what, where, "export the model again");
}

std::vector<Float3> deltas_of(const GltfDocument& document,
                              const std::map<std::string, int>& target, const char* name,
                              const std::string& where) {
    const auto found = target.find(name);
    if (found == target.end()) return {};
    return read_vectors<Float3>(document, found->second, where);
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

MotionSkin read_skin(const GltfDocument& document, int index, const std::vector<GltfNode>& nodes) {
    const tinygltf::Skin& skin = document.model.skins.at(static_cast<size_t>(index));
    const std::string where = document.place("skins", static_cast<size_t>(index));
    std::unordered_map<int, size_t> places;
    for (size_t i = 0; i < nodes.size(); ++i)
        places[static_cast<int>(nodes[i].index)] = i;
    std::vector<float> inverse_bind;
    if (skin.inverseBindMatrices >= 0) {
        const auto& accessor = checked_accessor(document, skin.inverseBindMatrices, where);
        if (accessor.type != TINYGLTF_TYPE_MAT4 || accessor.count < skin.joints.size())
            fail("there are fewer matrices than joints", where);
        inverse_bind = read_floats(document, skin.inverseBindMatrices, where);
    }
    MotionSkin read;
    for (size_t j = 0; j < skin.joints.size(); ++j) {
        const auto place = places.find(skin.joints[j]);
        if (place == places.end()) return {};
        DoubleMat4 bind(1);
        for (size_t k = 0; k < 16 && !inverse_bind.empty(); ++k)
            bind[static_cast<int>(k / 4)][static_cast<int>(k % 4)] = inverse_bind[j * 16 + k];
        read.joints.push_back(place->second);
        read.joint_from_mesh.push_back(bind);
    }
    return read;
}

std::vector<DoubleMat4> joint_matrices(const MotionSkin& skin, const std::vector<GltfNode>& nodes) {
    std::vector<DoubleMat4> matrices;
    for (size_t j = 0; j < skin.joints.size(); ++j)
        matrices.push_back(nodes[skin.joints[j]].world * skin.joint_from_mesh[j]);
    return matrices;
}

std::vector<MorphTarget> read_targets(const GltfDocument& document,
                                      const tinygltf::Primitive& primitive,
                                      const std::vector<double>& weights, bool all,
                                      const std::string& where) {
    const size_t count =
        all ? primitive.targets.size() : std::min(weights.size(), primitive.targets.size());
    std::vector<MorphTarget> targets(count);
    for (size_t t = 0; t < count; ++t) {
        if (!all && weights[t] == 0) continue;
        const auto& target = primitive.targets[t];
        targets[t] = {deltas_of(document, target, "POSITION", where),
                      deltas_of(document, target, "NORMAL", where),
                      deltas_of(document, target, "TANGENT", where)};
    }
    return targets;
}

}  // namespace tp
