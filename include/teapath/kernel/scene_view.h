// The flat arrays of a scene, as a kernel sees them.
#pragma once

#include <teapath/kernel/bsdf/albedo_table.h>
#include <teapath/kernel/records.h>

namespace tp {

struct SceneView {
    Span<const Hittable> hittables;
    Span<const BvhNode> nodes;
    Span<const MeshView> meshes;
    Span<const InstanceRecord> instances;
    Span<const PlacementRecord> placements;  // by growing hittable
    Span<const LightRecord> lights;
    Span<const LightNode> light_nodes;
    Span<const MaterialRecord> materials;
    Span<const uint32_t> material_ids;
    Span<const PrincipledRecord> principled;
    AlbedoTables albedo_tables;
    Span<const TextureRecord> textures;
    const unsigned char* texels = nullptr;
    const float* srgb_table = nullptr;  // 256 entries: linear value of an 8-bit code
    BackgroundRecord background;
    EnvironmentView environment;
    Bounds bounds;             // of all hittables
    bool brute_force = false;  // tests: visit every hittable instead of the tree
};

}  // namespace tp
