#include "gltf_read.h"

#include "../mesh/mesh_finish.h"
#include "gltf_animations.h"
#include "gltf_document.h"
#include "gltf_extensions.h"
#include "gltf_instances.h"
#include "gltf_lights.h"
#include "gltf_materials.h"
#include "gltf_mesh.h"
#include "gltf_meshopt.h"
#include "gltf_nodes.h"

#include <teapath/core/error.h>
#include <teapath/core/parallel.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace tp {
namespace {

class GltfReader {
public:
    GltfReader(std::string bytes, const ModelSource& source)
        : source_(source),
          document_(parse_gltf(std::move(bytes), source)),
          textures_(document_, content_),
          progress_(source) {}

    ModelContent read() {
        content_.unsupported = check_extensions(document_);
        decode_meshopt_views(document_);
        nodes_ = nodes_of_scene(document_);
        find_motion();
        collect_primitives();
        read_meshes();
        add_materials(document_, textures_, content_);
        progress_.begin(0.5, content_.textures.size());
        textures_.load_images(progress_);
        place_objects();
        add_cameras(document_, nodes_, content_);
        add_lights(document_, nodes_, content_);
        if (content_.objects.empty())
            content_.unsupported.push_back("The scene of the file has no triangles.");
        keep_motion();
        return std::move(content_);
    }

private:
    // A primitive of a mesh; null: without triangles.
    struct MeshPart {
        std::shared_ptr<const Mesh> mesh;
        std::shared_ptr<const DeformableMesh> deformable;  // null: it keeps its form
    };
    using MeshParts = std::vector<MeshPart>;

    // One primitive to be read.
    struct Job {
        const MeshUse* use;
        MeshPart* made;
        size_t part;
    };

    void find_motion() {
        motion_.animations = read_animations(document_, nodes_, content_.unsupported);
        motion_.nodes = motion_nodes(document_, nodes_);
        moving_ = moving_nodes(motion_.animations, nodes_);
        morphing_ = morphing_nodes(motion_.animations, nodes_.size());
    }

    void collect_primitives() {
        double bytes = 0;
        for (size_t n = 0; n < nodes_.size(); ++n) {
            const GltfNode& node = nodes_[n];
            if (document_.model.nodes[node.index].mesh < 0) continue;
            const auto [entry, is_new] = parts_.try_emplace(use_of_mesh(document_, node.index));
            uses_.emplace(node.index, &*entry);
            const MeshUse& use = entry->first;
            if (use.skin >= 0 && !skins_.contains(use.skin)) find_joints(use.skin);
            if (morphing_[n] || moves(use.skin)) changing_.insert(&use);
            if (!is_new) continue;
            const auto& primitives = document_.model.meshes[use.mesh].primitives;
            entry->second.resize(primitives.size());
            for (size_t p = 0; p < primitives.size(); ++p) {
                if (!has_triangles(primitives[p])) {
                    ++points_and_lines_;
                    continue;
                }
                bytes += bytes_of_primitive(document_, primitives[p], place_of(use.mesh, p));
                bytes += bytes_of_targets(primitives[p]);
                jobs_.push_back({&use, &entry->second[p], p});
            }
        }
        check_memory(source_, bytes);
        if (points_and_lines_ > 0)
            content_.unsupported.push_back(
                fmt::format("Points and lines cannot be shown: {} primitives are left out.",
                            points_and_lines_));
    }

    void find_joints(int skin) {
        const MotionSkin& read = skins_[skin] = read_skin(document_, skin, nodes_);
        joints_[skin] = joint_matrices(read, nodes_);
        if (read.joints.empty())
            content_.unsupported.push_back(
                fmt::format("Skin {} has no joints in the scene and is left out.", skin));
    }

    void read_meshes() {
        progress_.begin(0.5, jobs_.size());
        shared_pool().for_each(static_cast<int64_t>(jobs_.size()), [&](int64_t i) {
            const Job& job = jobs_[static_cast<size_t>(i)];
            const std::string where = place_of(job.use->mesh, job.part);
            read_job(job, where);
            progress_.step();
        });
    }

    void read_job(const Job& job, const std::string& where) const {
        const MeshUse& use = *job.use;
        const auto& primitive = document_.model.meshes[use.mesh].primitives[job.part];
        const bool changes = changing_.contains(&use);
        DeformableMesh read;
        read.mesh =
            read_primitive(document_, primitive, where, is_skinned(use) ? &read.skin : nullptr);
        if (read.mesh.triangles.empty()) return;
        read.targets = read_targets(document_, primitive, use.weights, changes, where);
        const std::vector<DoubleMat4> joints =
            is_skinned(use) ? joints_.at(use.skin) : std::vector<DoubleMat4>();
        if (std::string problem = problem_of(read, joints.size()); !problem.empty())
            throw Error(ErrorKind::Input, std::move(problem), where, "export the model again");
        const bool deforms = is_skinned(use) || !read.targets.empty();
        if (!deforms) {
            job.made->mesh = share(finish_mesh(std::move(read.mesh), where));
            return;
        }
        finish_mesh(read.mesh, where);  // its indices are good from here on
        job.made->mesh = share(finish_mesh(deformed(read, use.weights, joints, false), where));
        if (changes) job.made->deformable = std::make_shared<const DeformableMesh>(std::move(read));
    }

    double bytes_of_targets(const tinygltf::Primitive& primitive) const {
        double bytes = 0;
        for (const auto& target : primitive.targets)
            for (const auto& [name, accessor] : target)
                if (accessor >= 0 &&
                    static_cast<size_t>(accessor) < document_.model.accessors.size())
                    bytes +=
                        12.0 * static_cast<double>(
                                   document_.model.accessors[static_cast<size_t>(accessor)].count);
        return bytes;
    }

    // True if some animation moves a joint of the skin.
    bool moves(int skin) const {
        if (skin < 0) return false;
        const auto& joints = skins_.at(skin).joints;
        return std::any_of(joints.begin(), joints.end(), [&](size_t j) { return moving_[j]; });
    }

    bool is_skinned(const MeshUse& use) const {
        return use.skin >= 0 && !joints_.at(use.skin).empty();
    }

    void place_objects() {
        UniqueNames paths;
        size_t flat = 0;
        for (size_t n = 0; n < nodes_.size(); ++n) {
            const GltfNode& node = nodes_[n];
            const auto use = uses_.find(node.index);
            if (use == uses_.end()) continue;
            // A skin's joints say where it is, its node does not.
            const std::vector<DoubleMat4> places = is_skinned(use->second->first)
                                                       ? std::vector<DoubleMat4>{DoubleMat4(1)}
                                                       : places_of(document_, node);
            for (size_t i = 0; i < places.size(); ++i) {
                const auto split = split_transform(places[i]);
                const std::string instance =
                    places.size() == 1 ? std::string() : fmt::format(":{}", i + 1);
                if (split)
                    place_mesh(n, instance, *use->second, *split, paths);
                else
                    ++flat;
            }
        }
        if (flat > 0)
            content_.unsupported.push_back(
                fmt::format("{} nodes are scaled to nothing and left out.", flat));
    }

    void place_mesh(size_t index, const std::string& instance,
                    const std::pair<const MeshUse, MeshParts>& use, const SplitTransform& split,
                    UniqueNames& paths) {
        const auto& [how, parts] = use;
        const GltfNode& node = nodes_[index];
        const size_t mesh = how.mesh;
        for (size_t p = 0; p < parts.size(); ++p) {
            if (!parts[p].mesh) continue;
            const bool is_alone = parts.size() == 1;
            Object object;
            object.id = ObjectId{static_cast<uint32_t>(content_.objects.size() + 1)};
            const std::string ending =
                instance + (is_alone ? std::string() : fmt::format(".{}", p + 1));
            object.name = node.name + ending;
            object.part.path = paths.add(node.path + ending);
            MeshShape shape;
            shape.file = {mesh_path(how, node, p), parts[p].mesh};
            shape.placement = split.placement;
            object.shape = std::move(shape);
            object.transform = split.transform;
            object.material = material_of(mesh, p);
            if (moving_[index] || parts[p].deformable)
                motion_.parts[object.part.path] = {index, skin_of(how), parts[p].deformable,
                                                   parts[p].mesh};
            content_.objects.push_back(std::move(object));
        }
    }

    MaterialId material_of(size_t mesh, size_t part) {
        const int material = document_.model.meshes[mesh].primitives[part].material;
        const size_t count = document_.model.materials.size();
        if (material < 0) return default_material(content_, count);
        if (static_cast<size_t>(material) >= count)
            throw Error(ErrorKind::Input, fmt::format("there is no material {}", material),
                        place_of(mesh, part), "export the model again");
        return MaterialId{static_cast<uint32_t>(material + 1)};
    }

    // The number of a use's skin among those of the motion; kNoIndex: it has none.
    size_t skin_of(const MeshUse& use) {
        if (!is_skinned(use)) return kNoIndex;
        const auto [entry, is_new] = skin_indices_.try_emplace(use.skin, motion_.skins.size());
        if (is_new) motion_.skins.push_back(skins_.at(use.skin));
        return entry->second;
    }

    void keep_motion() {
        for (size_t n = 0; n < nodes_.size(); ++n)
            for (const ModelLight& light : content_.lights)
                if (moving_[n] && light.part.path == nodes_[n].path)
                    motion_.parts["light:" + light.part.path] = {n, kNoIndex, nullptr, nullptr};
        const auto& cameras = document_.model.nodes;
        const bool moves_camera = [&] {
            for (size_t n = 0; n < nodes_.size(); ++n)
                if (moving_[n] && cameras[nodes_[n].index].camera >= 0) return true;
            return false;
        }();
        if (moves_camera)
            content_.unsupported.push_back("Cameras stand still, though an animation moves one.");
        if (!motion_.animations.empty())
            content_.motion = std::make_shared<const ModelMotion>(std::move(motion_));
    }

    std::string place_of(size_t mesh, size_t part) const {
        return fmt::format("{}.primitives[{}]", document_.place("meshes", mesh), part);
    }
    std::string mesh_path(const MeshUse& use, const GltfNode& node, size_t part) const {
        std::string path = fmt::format("{}#mesh/{}/{}", file_name(), use.mesh, part);
        if (!use.weights.empty() || is_skinned(use)) path += fmt::format("/node/{}", node.index);
        return path;
    }
    std::string file_name() const {
        return std::filesystem::path(source_.name).filename().string();
    }

    const ModelSource& source_;
    GltfDocument document_;
    ModelContent content_;
    GltfTextures textures_;
    ModelProgress progress_;
    std::vector<GltfNode> nodes_;
    std::map<MeshUse, MeshParts> parts_;
    std::map<size_t, const std::pair<const MeshUse, MeshParts>*> uses_;  // by node
    ModelMotion motion_;
    std::vector<bool> moving_, morphing_;            // of nodes_
    std::set<const MeshUse*> changing_;              // their meshes change their form
    std::map<int, MotionSkin> skins_;                // by the file's numbers
    std::map<int, size_t> skin_indices_;             // of motion_.skins
    std::map<int, std::vector<DoubleMat4>> joints_;  // by skin, at rest
    std::vector<Job> jobs_;
    size_t points_and_lines_ = 0;
};

}  // namespace

ModelContent read_gltf(std::string bytes, const ModelSource& source) {
    return GltfReader(std::move(bytes), source).read();
}

}  // namespace tp
