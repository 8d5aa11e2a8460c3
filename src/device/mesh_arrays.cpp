#include <teapath/core/parallel.h>
#include <teapath/device/bvh_build.h>
#include <teapath/device/mesh_arrays.h>

#include <map>
#include <mutex>

namespace tp {
namespace {

template <class T>
size_t bytes_of(const std::vector<T>& v) {
    return v.size() * sizeof(T);
}
template <class T>
const T* data_or_null(const std::vector<T>& v) {
    return v.empty() ? nullptr : v.data();
}

template <class To, class From>
std::vector<To> converted(const std::vector<From>& from) {
    return {from.begin(), from.end()};
}

template <class F>
void for_each_index(size_t count, F&& f) {
    parallel_for(static_cast<int64_t>(count), 16384, [&](int64_t first, int64_t last) {
        for (auto i = static_cast<size_t>(first); i < static_cast<size_t>(last); ++i)
            f(i);
    });
}

std::shared_ptr<const MeshArrays> build(const Mesh& mesh) {
    auto arrays = std::make_shared<MeshArrays>();
    std::vector<Bounds> boxes(mesh.triangles.size());
    const auto corner = [&](uint32_t vertex) {
        return MeshCorner{Vec3(mesh.positions[vertex]), vertex};
    };
    for_each_index(boxes.size(), [&](size_t i) {
        for (const uint32_t vertex : mesh.triangles[i])
            boxes[i] = join(boxes[i], Vec3(mesh.positions[vertex]));
    });
    BvhTree tree = build_bvh(boxes);
    arrays->triangles.resize(boxes.size());
    for_each_index(boxes.size(), [&](size_t i) {
        const auto& t = mesh.triangles[tree.order[i]];
        arrays->triangles[i] = {corner(t[0]), corner(t[1]), corner(t[2])};
    });
    arrays->nodes = std::move(tree.nodes);
    arrays->bounds = tree.bounds;
    arrays->bvh = tree.stats;

    arrays->normals = converted<Vec3>(mesh.normals);
    arrays->tangents = converted<Vec4>(mesh.tangents);
    for (size_t set = 0; set < arrays->uvs.size() && set < mesh.uvs.size(); ++set)
        arrays->uvs[set] = converted<Vec2>(mesh.uvs[set]);
    arrays->colors = converted<Vec4>(mesh.colors);
    return arrays;
}

// What has been made and is still held by somebody.
struct Cache {
    struct Entry {
        std::weak_ptr<const Mesh> mesh;  // tells a new mesh at the address of an old one
        std::weak_ptr<const MeshArrays> arrays;
    };
    std::mutex mutex;
    std::map<const Mesh*, Entry> entries;
};

Cache& cache() {
    static Cache all;
    return all;
}

}  // namespace

size_t MeshArrays::bytes() const {
    return bytes_of(nodes) + bytes_of(triangles) + bytes_of(normals) + bytes_of(tangents) +
           bytes_of(uvs[0]) + bytes_of(uvs[1]) + bytes_of(colors);
}

MeshView MeshArrays::view() const {
    return {make_span(nodes),
            make_span(triangles),
            {data_or_null(normals),
             data_or_null(tangents),
             {data_or_null(uvs[0]), data_or_null(uvs[1])},
             data_or_null(colors)}};
}

std::shared_ptr<const MeshArrays> arrays_of(const std::shared_ptr<const Mesh>& mesh) {
    {
        const std::lock_guard lock(cache().mutex);
        std::erase_if(cache().entries, [](const auto& e) { return e.second.arrays.expired(); });
        const auto found = cache().entries.find(mesh.get());
        if (found != cache().entries.end() && found->second.mesh.lock() == mesh)
            if (auto arrays = found->second.arrays.lock()) return arrays;
    }
    auto arrays = build(*mesh);
    const std::lock_guard lock(cache().mutex);
    cache().entries[mesh.get()] = {mesh, arrays};
    return arrays;
}

}  // namespace tp
