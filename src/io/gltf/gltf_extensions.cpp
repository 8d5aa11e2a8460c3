#include "gltf_extensions.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace tp {
namespace {

constexpr std::array<std::string_view, 21> kSupported = {
    "EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression",
    "EXT_texture_webp",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_diffuse_transmission",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "KHR_xmp_json_ld",  // says who made it; nothing to show
};

// Without these the model is still what it is.
constexpr std::array<std::string_view, 8> kIgnorable = {
    "KHR_animation_pointer",  "KHR_materials_variants", "KHR_node_visibility",      "KHR_xmp",
    "EXT_lights_image_based", "KHR_audio_emitter",      "KHR_physics_rigid_bodies", "MSFT_lod",
};

template <class List>
bool contains(const List& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

}  // namespace

std::vector<std::string> check_extensions(const GltfDocument& document) {
    for (const std::string& name : document.model.extensionsRequired)
        if (!contains(kSupported, name) && !contains(kIgnorable, name))
            throw Error(
                ErrorKind::Input,
                fmt::format("the model needs the glTF extension {}, which is not supported", name),
                document.source->name, "export it without that extension");
    std::vector<std::string> sentences;
    for (const std::string& name : document.model.extensionsUsed)
        if (!contains(kSupported, name))
            sentences.push_back(fmt::format("The glTF extension {} is left out.", name));
    return sentences;
}

}  // namespace tp
