#include "gltf_instances.h"

#include "gltf_accessor.h"
#include "gltf_value.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

namespace tp {
namespace {

constexpr size_t kMostInstances = size_t{1} << 20;

template <class Vector>
std::vector<Vector> list_of(const GltfDocument& document, const tinygltf::Value& attributes,
                            const char* name, const std::string& where) {
    const int accessor = index_in(attributes, name, -1);
    if (accessor < 0) return {};
    return read_vectors<Vector>(document, accessor, where);
}

}  // namespace

std::vector<DoubleMat4> places_of(const GltfDocument& document, const GltfNode& node) {
    const auto* extension =
        find_extension(document.model.nodes[node.index].extensions, "EXT_mesh_gpu_instancing");
    const auto* attributes = extension ? find_value(*extension, "attributes") : nullptr;
    if (!attributes || !attributes->IsObject()) return {node.world};
    const std::string where = document.place("nodes", node.index);
    const auto translations = list_of<Float3>(document, *attributes, "TRANSLATION", where);
    const auto rotations = list_of<Float4>(document, *attributes, "ROTATION", where);
    const auto scales = list_of<Float3>(document, *attributes, "SCALE", where);
    const size_t count = std::max({translations.size(), rotations.size(), scales.size()});
    for (const size_t size : {translations.size(), rotations.size(), scales.size()})
        if (size != 0 && size != count)
            throw Error(ErrorKind::Input, "the instances' lists are not of one length", where,
                        "export the model again");
    if (count > kMostInstances)
        throw Error(ErrorKind::Input, fmt::format("{} instances are too many", count), where,
                    "at most 1,048,576");
    std::vector<DoubleMat4> places;
    places.reserve(count);
    for (size_t i = 0; i < count; ++i)
        places.push_back(
            node.world *
            placement_matrix(translations.empty() ? Double3(0) : Double3(translations[i]),
                             rotations.empty() ? Double4(0, 0, 0, 1) : Double4(rotations[i]),
                             scales.empty() ? Double3(1) : Double3(scales[i])));
    return places;
}

}  // namespace tp
