// What the fuzzers of models and images do with an input: whatever it is, it becomes content that
// keeps its promises, or an Error. No files are opened.
#pragma once

#include "io/gltf/gltf_read.h"
#include "io/obj/obj_materials.h"
#include "io/obj/obj_model.h"

#include <teapath/core/error.h>
#include <teapath/io/image_file.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace tp::test {

inline ModelSource fuzz_source() {
    ModelSource source;
    source.name = "fuzz";
    source.has_files = false;
    source.memory = uint64_t{256} << 20;
    return source;
}

inline bool is_sound(const Image& image) {
    const size_t depth = image.format == PixelFormat::U8    ? 1
                         : image.format == PixelFormat::U16 ? 2
                                                            : 4;
    return image.width > 0 && image.height > 0 && image.channels >= 1 && image.channels <= 4 &&
           image.bytes.size() == static_cast<size_t>(image.width) *
                                     static_cast<size_t>(image.height) *
                                     static_cast<size_t>(image.channels) * depth;
}

/// Ids that exist, and meshes without problems.
inline bool is_sound(const ModelContent& content) {
    const auto is_mesh = [](const Object& object) {
        const auto* shape = std::get_if<MeshShape>(&object.shape);
        return shape && shape->file.mesh && problem_of(*shape->file.mesh).empty();
    };
    const auto has_material = [&](const Object& object) {
        return object.material.value >= 1 && object.material.value <= content.materials.size();
    };
    const auto has_sound_image = [](const Texture& texture) {
        return !texture.file.image || is_sound(*texture.file.image);
    };
    const auto has_textures = [&](const Material& m) {
        return m.color.texture.value <= content.textures.size() &&
               m.surface.normal.value <= content.textures.size();
    };
    return std::all_of(content.objects.begin(), content.objects.end(), is_mesh) &&
           std::all_of(content.objects.begin(), content.objects.end(), has_material) &&
           std::all_of(content.materials.begin(), content.materials.end(), has_textures) &&
           std::all_of(content.textures.begin(), content.textures.end(), has_sound_image);
}

/// A .gltf or .glb file.
inline bool fuzz_gltf(const uint8_t* data, size_t size) {
    const ModelSource source = fuzz_source();
    try {
        return is_sound(read_gltf(std::string(reinterpret_cast<const char*>(data), size), source));
    } catch (const Error&) {
        return true;
    }
}

/// The first byte chooses between an OBJ file and a material library.
inline bool fuzz_obj_model(const uint8_t* data, size_t size) {
    if (size == 0) return true;
    const ModelSource source = fuzz_source();
    const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        if (data[0] % 2 == 0) return is_sound(read_obj_model(text, source));
        std::map<std::string, MtlMaterial> materials;
        read_mtl(text, materials);
        ModelContent content;
        ObjTextures textures(source, content);
        for (const auto& [name, material] : materials)
            content.materials.push_back(material_of(material, textures));
        ModelProgress progress(source);
        textures.load_images(progress);
        return is_sound(content);
    } catch (const Error&) {
        return true;
    }
}

/// An image file of any format.
inline bool fuzz_image(const uint8_t* data, size_t size) {
    try {
        return is_sound(
            read_image_from_memory(std::string(reinterpret_cast<const char*>(data), size), "fuzz"));
    } catch (const Error&) {
        return true;
    }
}

}  // namespace tp::test
