// The scene as the kernels read it: flat arrays, derived from the document and never edited.
#pragma once

#include <teapath/device/bvh_stats.h>
#include <teapath/device/environment_arrays.h>
#include <teapath/device/mesh_arrays.h>
#include <teapath/kernel/launch_params.h>
#include <teapath/kernel/records.h>
#include <teapath/scene/scene.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace tp {

/// Parts of the arrays, as bits, for partial rebuilds and uploads.
enum class SceneParts : uint32_t {
    None = 0,
    Geometry = 1,    // hittables, nodes, meshes that are new
    Materials = 2,   // material and texture records, texels, background
    Parameters = 4,  // camera and settings
    All = 7          // lights follow from geometry and materials
};
constexpr SceneParts operator|(SceneParts a, SceneParts b) {
    return static_cast<SceneParts>(static_cast<uint32_t>(a) | static_cast<uint32_t>(b));
}
constexpr bool has(SceneParts parts, SceneParts part) {
    return (static_cast<uint32_t>(parts) & static_cast<uint32_t>(part)) != 0;
}

/// A mesh of the scene and what was made of it.
struct MeshOfScene {
    std::weak_ptr<const Mesh> source;
    std::shared_ptr<const MeshArrays> arrays;
};

struct SceneArrays {
    std::vector<Hittable> hittables;          // in the order of the tree's leaves
    std::vector<BvhNode> nodes;               // node 0 is the root; empty for an empty scene
    std::vector<MeshOfScene> meshes;          // each once, however many instances it has
    std::vector<InstanceRecord> instances;    // in the order of the objects
    std::vector<PlacementRecord> placements;  // of shapes with a transform, by growing hittable
    std::vector<LightRecord> lights;
    std::vector<LightNode> light_nodes;  // node 0 is the root; empty without lights
    std::vector<MaterialRecord> materials;
    std::vector<PrincipledRecord> principled;
    std::vector<uint32_t> material_ids;  // MaterialId::value of each record
    std::vector<TextureRecord> textures;
    std::vector<std::byte> texels;  // all images, each aligned to 16 bytes
    BackgroundRecord background;
    std::shared_ptr<const EnvironmentArrays> environment;  // null: no image to aim at
    CameraRecord camera;
    PathSettings settings;
    Bounds bounds;             // of all hittables
    uint32_t features = 0;     // SceneFeature bits that the scene needs
    bool brute_force = false;  // tests: traversal visits every hittable
    BvhStats bvh;

    size_t bytes() const;
};

/// True if kernels read SceneView::albedo_tables.
inline bool needs_albedo_tables(const SceneArrays& arrays) {
    return (arrays.features & kFeaturePrincipled) != 0;
}

/// Rebuilds `parts` of the arrays from the document, on all cores. The scene must be valid
/// (validate() finds nothing fatal); generators are expanded here.
void flatten(const Scene& scene, SceneParts parts, SceneArrays& arrays);

/// Which parts of the arrays differ between two snapshots; names are in none of them.
SceneParts changed_parts(const Scene& before, const Scene& after);

}  // namespace tp
