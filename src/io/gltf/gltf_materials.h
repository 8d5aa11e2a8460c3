// Materials of a glTF file as principled surfaces, with the extensions that these have.
#pragma once

#include "gltf_textures.h"

namespace tp {

/// Appends one material for each of the file's, ids from 1, and their textures. Throws
/// Error(Input) for textures that do not exist.
void add_materials(const GltfDocument& document, GltfTextures& textures, ModelContent& content);

/// The material of what names none: white, metallic and rough, as glTF 2.0 has it. Appends it at
/// the first call.
MaterialId default_material(ModelContent& content, size_t materials_of_file);

}  // namespace tp
