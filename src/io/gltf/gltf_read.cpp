#include "gltf_read.h"

#include "../mesh/mesh_finish.h"
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

#include <filesystem>
#include <map>
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
        say_what_stands_still();
        return std::move(content_);
    }

private:
    // The primitives of one mesh; null: without triangles.
    using MeshParts = std::vector<std::shared_ptr<const Mesh>>;

    // One primitive to be read.
    struct Job {
        const MeshUse* use;
        std::shared_ptr<const Mesh>* mesh;
        size_t part;
    };

    void collect_primitives() {
        double bytes = 0;
        for (const GltfNode& node : nodes_) {
            if (document_.model.nodes[node.index].mesh < 0) continue;
            const auto [entry, is_new] = parts_.try_emplace(use_of_mesh(document_, node.index));
            uses_.emplace(node.index, &*entry);
            if (!is_new) continue;
            const MeshUse& use = entry->first;
            const auto& primitives = document_.model.meshes[use.mesh].primitives;
            entry->second.resize(primitives.size());
            if (use.skin >= 0 && !joints_.contains(use.skin)) find_joints(use.skin);
            for (size_t p = 0; p < primitives.size(); ++p) {
                if (!has_triangles(primitives[p])) {
                    ++points_and_lines_;
                    continue;
                }
                bytes += bytes_of_primitive(document_, primitives[p], place_of(use.mesh, p));
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
        const auto& joints = joints_[skin] = joint_matrices(document_, skin, nodes_);
        if (joints.empty())
            content_.unsupported.push_back(
                fmt::format("Skin {} has no joints in the scene and is left out.", skin));
    }

    void read_meshes() {
        progress_.begin(0.5, jobs_.size());
        shared_pool().for_each(static_cast<int64_t>(jobs_.size()), [&](int64_t i) {
            const Job& job = jobs_[static_cast<size_t>(i)];
            const std::string where = place_of(job.use->mesh, job.part);
            Mesh mesh = read_job(job, where);
            if (!mesh.triangles.empty()) *job.mesh = share(finish_mesh(std::move(mesh), where));
            progress_.step();
        });
    }

    Mesh read_job(const Job& job, const std::string& where) const {
        const auto& primitive = document_.model.meshes[job.use->mesh].primitives[job.part];
        SkinWeights skin;
        Mesh mesh =
            read_primitive(document_, primitive, where, is_skinned(*job.use) ? &skin : nullptr);
        apply_morph(document_, primitive, job.use->weights, where, mesh);
        if (is_skinned(*job.use)) apply_skin(skin, joints_.at(job.use->skin), where, mesh);
        return mesh;
    }

    bool is_skinned(const MeshUse& use) const {
        return use.skin >= 0 && !joints_.at(use.skin).empty();
    }

    void place_objects() {
        UniqueNames paths;
        size_t flat = 0;
        for (const GltfNode& node : nodes_) {
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
                    place_mesh(node, instance, *use->second, *split, paths);
                else
                    ++flat;
            }
        }
        if (flat > 0)
            content_.unsupported.push_back(
                fmt::format("{} nodes are scaled to nothing and left out.", flat));
    }

    void place_mesh(const GltfNode& node, const std::string& instance,
                    const std::pair<const MeshUse, MeshParts>& use, const SplitTransform& split,
                    UniqueNames& paths) {
        const auto& [how, parts] = use;
        const size_t mesh = how.mesh;
        for (size_t p = 0; p < parts.size(); ++p) {
            if (!parts[p]) continue;
            const bool is_alone = parts.size() == 1;
            Object object;
            object.id = ObjectId{static_cast<uint32_t>(content_.objects.size() + 1)};
            const std::string ending =
                instance + (is_alone ? std::string() : fmt::format(".{}", p + 1));
            object.name = node.name + ending;
            object.part.path = paths.add(node.path + ending);
            MeshShape shape;
            shape.file = {mesh_path(how, node, p), parts[p]};
            shape.placement = split.placement;
            object.shape = std::move(shape);
            object.transform = split.transform;
            object.material = material_of(mesh, p);
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

    void say_what_stands_still() {
        if (document_.animations > 0)
            content_.unsupported.push_back("Animations are left out; the model stands as it is.");
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
    std::map<int, std::vector<DoubleMat4>> joints_;                      // by skin
    std::vector<Job> jobs_;
    size_t points_and_lines_ = 0;
};

}  // namespace

ModelContent read_gltf(std::string bytes, const ModelSource& source) {
    return GltfReader(std::move(bytes), source).read();
}

}  // namespace tp
