#include "gltf_nodes.h"

#include "../model/unique_names.h"
#include "gltf_value.h"

#include <teapath/core/error.h>
#include <teapath/scene/animation.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace tp {
namespace {

constexpr int kMaxDepth = 1000;

DoubleMat4 matrix_of(const tinygltf::Node& node) {
    DoubleMat4 m(1);
    if (node.matrix.size() == 16) {
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r)
                m[c][r] = node.matrix[static_cast<size_t>(4 * c + r)];
        for (int c = 0; c < 4; ++c)
            m[c][3] = c == 3 ? 1 : 0;
        return m;
    }
    return placement_matrix(vector_of(node.translation, Double3(0)),
                            vector_of(node.rotation, Double4(0, 0, 0, 1)),
                            vector_of(node.scale, Double3(1)));
}

class Walker {
public:
    explicit Walker(const GltfDocument& document)
        : document_(document), nodes_(document.model.nodes), visited_(nodes_.size()) {}

    std::vector<GltfNode> walk() {
        open(roots(), kNoIndex, {}, DoubleMat4(1));
        while (!levels_.empty()) {
            Level& level = levels_.back();
            if (level.next == level.children.size()) {
                levels_.pop_back();
                continue;
            }
            const int child = level.children[level.next++];
            visit(child, level);
        }
        return std::move(found_);
    }

private:
    // A parent whose children are being visited.
    struct Level {
        std::vector<int> children;
        size_t next;
        size_t parent;  // in the list
        std::string path;
        DoubleMat4 world;
        UniqueNames names;
    };

    [[noreturn]] void fail(const std::string& what, const std::string& where) const {
        throw Error(ErrorKind::Input, what, where, "export the model again");
    }

    std::vector<int> roots() const {
        const auto& model = document_.model;
        if (!model.scenes.empty()) {
            const int scene = model.defaultScene < 0 ? 0 : model.defaultScene;
            if (static_cast<size_t>(scene) >= model.scenes.size())
                fail(fmt::format("there is no scene {}", scene), document_.source->name);
            return model.scenes[static_cast<size_t>(scene)].nodes;
        }
        std::vector<bool> is_child(nodes_.size());
        for (const auto& node : nodes_)
            for (const int child : node.children)
                if (child >= 0 && static_cast<size_t>(child) < nodes_.size())
                    is_child[static_cast<size_t>(child)] = true;
        std::vector<int> roots;
        for (size_t i = 0; i < nodes_.size(); ++i)
            if (!is_child[i]) roots.push_back(static_cast<int>(i));
        return roots;
    }

    void open(std::vector<int> children, size_t parent, std::string path, const DoubleMat4& world) {
        levels_.push_back({std::move(children), 0, parent, std::move(path), world, {}});
    }

    void visit(int child, Level& level) {
        const auto index = static_cast<size_t>(child);
        if (child < 0 || index >= nodes_.size())
            fail(fmt::format("there is no node {}", child), document_.source->name);
        const std::string where = document_.place("nodes", index);
        if (visited_[index]) fail("the node has two parents, or is below itself", where);
        visited_[index] = true;
        const tinygltf::Node& node = nodes_[index];
        GltfNode found;
        found.index = index;
        found.parent = level.parent;
        found.name = level.names.add(node.name.empty() ? fmt::format("node {}", index)
                                                       : path_piece(node.name));
        found.path = level.path.empty() ? found.name : level.path + "/" + found.name;
        found.own = matrix_of(node);
        found.world = level.world * found.own;
        for (int c = 0; c < 4; ++c)
            if (const double sum = glm::dot(found.world[c], Double4(1)); !std::isfinite(sum))
                fail("the node's place is not finite", where);
        if (levels_.size() >= kMaxDepth && !node.children.empty())
            fail(fmt::format("the nodes nest deeper than {} levels", kMaxDepth), where);
        found_.push_back(found);
        if (!node.children.empty()) open(node.children, found_.size() - 1, found.path, found.world);
    }

    const GltfDocument& document_;
    const std::vector<tinygltf::Node>& nodes_;
    std::vector<bool> visited_;
    std::vector<Level> levels_;
    std::vector<GltfNode> found_;
};

}  // namespace

std::vector<GltfNode> nodes_of_scene(const GltfDocument& document) {
    return Walker(document).walk();
}

}  // namespace tp
