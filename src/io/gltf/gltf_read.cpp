#include "gltf_read.h"

#include "../mesh/mesh_finish.h"
#include "../model/split_transform.h"
#include "gltf_document.h"
#include "gltf_extensions.h"
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

    void collect_primitives() {
        const auto& meshes = document_.model.meshes;
        double bytes = 0;
        for (const GltfNode& node : nodes_) {
            const int mesh = document_.model.nodes[node.index].mesh;
            if (mesh < 0) continue;
            const auto index = static_cast<size_t>(mesh);
            if (index >= meshes.size())
                throw Error(ErrorKind::Input, fmt::format("there is no mesh {}", mesh),
                            document_.place("nodes", node.index), "export the model again");
            const auto [parts, is_new] = parts_.try_emplace(index);
            if (!is_new) continue;
            const auto& primitives = meshes[index].primitives;
            parts->second.resize(primitives.size());
            for (size_t p = 0; p < primitives.size(); ++p) {
                if (!has_triangles(primitives[p])) {
                    ++points_and_lines_;
                    continue;
                }
                bytes += bytes_of_primitive(document_, primitives[p], place_of(index, p));
                jobs_.push_back({index, p});
            }
        }
        check_memory(source_, bytes);
        if (points_and_lines_ > 0)
            content_.unsupported.push_back(
                fmt::format("Points and lines cannot be shown: {} primitives are left out.",
                            points_and_lines_));
    }

    void read_meshes() {
        progress_.begin(0.5, jobs_.size());
        shared_pool().for_each(static_cast<int64_t>(jobs_.size()), [&](int64_t i) {
            const auto& [mesh, part] = jobs_[static_cast<size_t>(i)];
            const std::string where = place_of(mesh, part);
            Mesh read =
                read_primitive(document_, document_.model.meshes[mesh].primitives[part], where);
            if (!read.triangles.empty())
                parts_.at(mesh)[part] = share(finish_mesh(std::move(read), where));
            progress_.step();
        });
    }

    void place_objects() {
        UniqueNames paths;
        size_t flat = 0;
        for (const GltfNode& node : nodes_) {
            const int mesh = document_.model.nodes[node.index].mesh;
            if (mesh < 0) continue;
            const auto split = split_transform(node.world);
            if (!split) {
                ++flat;
                continue;
            }
            place_mesh(node, static_cast<size_t>(mesh), *split, paths);
        }
        if (flat > 0)
            content_.unsupported.push_back(
                fmt::format("{} nodes are scaled to nothing and left out.", flat));
    }

    void place_mesh(const GltfNode& node, size_t mesh, const SplitTransform& split,
                    UniqueNames& paths) {
        const MeshParts& parts = parts_.at(mesh);
        for (size_t p = 0; p < parts.size(); ++p) {
            if (!parts[p]) continue;
            const bool is_alone = parts.size() == 1;
            Object object;
            object.id = ObjectId{static_cast<uint32_t>(content_.objects.size() + 1)};
            object.name = is_alone ? node.name : fmt::format("{}.{}", node.name, p + 1);
            object.part.path =
                paths.add(is_alone ? node.path : fmt::format("{}.{}", node.path, p + 1));
            MeshShape shape;
            shape.file = {fmt::format("{}#mesh/{}/{}", file_name(), mesh, p), parts[p]};
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
        if (!document_.model.skins.empty())
            content_.unsupported.push_back("Skins are left out; bodies stand in their bind pose.");
        for (const auto& mesh : document_.model.meshes)
            for (const auto& primitive : mesh.primitives)
                if (!primitive.targets.empty()) {
                    content_.unsupported.push_back(
                        "Morph targets are left out; shapes stand as they are.");
                    return;
                }
    }

    std::string place_of(size_t mesh, size_t part) const {
        return fmt::format("{}.primitives[{}]", document_.place("meshes", mesh), part);
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
    std::map<size_t, MeshParts> parts_;
    std::vector<std::pair<size_t, size_t>> jobs_;
    size_t points_and_lines_ = 0;
};

}  // namespace

ModelContent read_gltf(std::string bytes, const ModelSource& source) {
    return GltfReader(std::move(bytes), source).read();
}

}  // namespace tp
