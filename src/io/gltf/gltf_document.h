// A glTF file taken apart: its JSON as tinygltf's structures, its buffers in memory, its images as
// they are stored. Buffers and images are taken out of the JSON before tinygltf sees it, so that
// what is read from where, and how much, is decided here.
#pragma once

#include "../json_text.h"
#include "../model/model_source.h"
#include "tinygltf.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// An image that is not decoded: a file's name, a buffer view, or bytes.
struct GltfImage {
    std::string name;
    std::string uri;  // of a file, decoded; empty if it is embedded
    int view = -1;
    std::shared_ptr<const std::string> bytes;  // of a data URI
    std::string type;                          // "image/png", or empty
};

struct GltfDocument {
    const ModelSource* source = nullptr;
    tinygltf::Model model;                                  // without buffers, images, animations
    std::vector<std::shared_ptr<const std::string>> bytes;  // what `buffers` points into
    std::vector<std::string_view> buffers;                  // empty: a fallback that is not there
    std::vector<GltfImage> images;
    std::vector<std::string> decoded;  // by buffer view: its bytes where they are compressed
    Json animations;                   // a list of objects

    /// "model.glb: meshes[3]": a place in the file for messages.
    std::string place(const char* list, size_t index) const;
};

/// Reads the JSON and the buffers. Throws Error(Input).
GltfDocument parse_gltf(std::string bytes, const ModelSource& source);

/// The bytes of a buffer view, decoded. Throws Error(Input) at `where` if there is no such view, or
/// it reaches beyond its buffer.
std::string_view bytes_of_view(const GltfDocument& document, int view, const std::string& where);

}  // namespace tp
