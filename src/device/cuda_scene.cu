#include <teapath/device/albedo_arrays.h>
#include <teapath/device/cuda_scene.cuh>
#include <teapath/device/srgb_table.h>

#include <algorithm>
#include <array>

namespace tp {
namespace {

constexpr size_t kAlignment = 256;

// An array of the host, and which part of the scene it belongs to.
struct Source {
    const void* data;
    size_t bytes;
    SceneParts parts;
};

template <class T>
Source source_of(const std::vector<T>& v, SceneParts parts) {
    return {v.data(), v.size() * sizeof(T), parts};
}

template <class T>
Span<const T> span_at(const std::byte* memory, size_t offset, const std::vector<T>& v) {
    return {reinterpret_cast<const T*>(memory + offset), static_cast<uint32_t>(v.size())};
}

}  // namespace

size_t CudaScene::bytes() const {
    size_t sum = memory_.allocated_bytes();
    for (const CudaMesh& mesh : meshes_)
        sum += mesh.bytes();
    return sum;
}

void CudaScene::upload_meshes(const std::vector<MeshOfScene>& meshes, const Stream& stream) {
    std::vector<CudaMesh> kept;
    kept.reserve(meshes.size());
    for (const MeshOfScene& mesh : meshes) {
        const auto found = std::find_if(meshes_.begin(), meshes_.end(),
                                        [&](const CudaMesh& m) { return m.holds(*mesh.arrays); });
        if (found != meshes_.end())
            kept.push_back(std::move(*found));
        else
            kept.emplace_back(mesh.arrays, stream);
    }
    meshes_ = std::move(kept);
}

void CudaScene::upload(const SceneArrays& arrays, SceneParts parts, const Stream& stream) {
    // Materials also renumber the lights, which hittables name.
    static const AlbedoArrays no_tables;
    const AlbedoArrays& albedo = needs_albedo_tables(arrays) ? albedo_arrays() : no_tables;
    static const EnvironmentArrays no_environment;
    const EnvironmentArrays& environment =
        arrays.environment ? *arrays.environment : no_environment;
    const SceneParts environment_parts =
        environment_ == arrays.environment ? SceneParts::None : SceneParts::All;
    const SceneParts either = SceneParts::Geometry | SceneParts::Materials;
    upload_meshes(arrays.meshes, stream);
    std::vector<MeshView> mesh_views;
    for (const CudaMesh& mesh : meshes_)
        mesh_views.push_back(mesh.view());
    const std::array<Source, 19> sources = {
        source_of(arrays.hittables, either),
        source_of(arrays.nodes, SceneParts::Geometry),
        source_of(arrays.lights, either),
        source_of(arrays.materials, SceneParts::Materials),
        source_of(arrays.material_ids, SceneParts::Materials),
        source_of(arrays.textures, SceneParts::Materials),
        source_of(arrays.texels, SceneParts::Materials),
        Source{srgb_table().data(), sizeof srgb_table(), SceneParts::None},
        source_of(mesh_views, SceneParts::Geometry),
        source_of(arrays.instances, SceneParts::Geometry),
        source_of(arrays.principled, SceneParts::Materials),
        source_of(albedo.ggx, SceneParts::None),
        source_of(albedo.ggx_average, SceneParts::None),
        source_of(albedo.sheen, SceneParts::None),
        source_of(albedo.glass, SceneParts::None),
        source_of(environment.rows, environment_parts),
        source_of(environment.cells, environment_parts),
        source_of(arrays.light_nodes, either),
        source_of(arrays.placements, SceneParts::Geometry)};

    // Where each array goes; the allocation is made anew where the sizes have changed.
    std::array<size_t, 19> offsets{};
    std::vector<size_t> layout;
    size_t total = 0;
    for (size_t i = 0; i < sources.size(); ++i) {
        offsets[i] = total;
        layout.push_back(sources[i].bytes);
        total += (sources[i].bytes + kAlignment - 1) / kAlignment * kAlignment;
    }
    const bool is_new = layout != layout_;
    if (is_new) {
        layout_.clear();
        memory_.resize(total);
    }
    for (size_t i = 0; i < sources.size(); ++i) {
        if (sources[i].bytes == 0 || !(is_new || has(parts, sources[i].parts))) continue;
        check(cudaMemcpyAsync(memory_.data() + offsets[i], sources[i].data, sources[i].bytes,
                              cudaMemcpyHostToDevice, stream.get()));
    }
    stream.wait();
    layout_ = layout;

    const std::byte* memory = memory_.data();
    view_.hittables = span_at(memory, offsets[0], arrays.hittables);
    view_.nodes = span_at(memory, offsets[1], arrays.nodes);
    view_.lights = span_at(memory, offsets[2], arrays.lights);
    view_.materials = span_at(memory, offsets[3], arrays.materials);
    view_.material_ids = span_at(memory, offsets[4], arrays.material_ids);
    view_.textures = span_at(memory, offsets[5], arrays.textures);
    view_.texels = reinterpret_cast<const unsigned char*>(memory + offsets[6]);
    view_.srgb_table = reinterpret_cast<const float*>(memory + offsets[7]);
    view_.meshes = span_at(memory, offsets[8], mesh_views);
    view_.instances = span_at(memory, offsets[9], arrays.instances);
    view_.principled = span_at(memory, offsets[10], arrays.principled);
    view_.albedo_tables = {span_at(memory, offsets[11], albedo.ggx).data,
                           span_at(memory, offsets[12], albedo.ggx_average).data,
                           span_at(memory, offsets[13], albedo.sheen).data,
                           span_at(memory, offsets[14], albedo.glass).data};
    environment_ = arrays.environment;
    view_.environment = {span_at(memory, offsets[15], environment.rows),
                         span_at(memory, offsets[16], environment.cells), environment.width,
                         environment.height};
    view_.light_nodes = span_at(memory, offsets[17], arrays.light_nodes);
    view_.placements = span_at(memory, offsets[18], arrays.placements);
    view_.background = arrays.background;
    view_.bounds = arrays.bounds;
    view_.brute_force = arrays.brute_force;
}

}  // namespace tp
