#include "gltf_draco.h"

#include "gltf_accessor.h"
#include "gltf_value.h"

#include <teapath/core/error.h>

#include <draco/compression/decode.h>
#include <draco/core/decoder_buffer.h>
#include <draco/mesh/mesh.h>
#include <fmt/format.h>

#include <exception>
#include <utility>

namespace tp {
namespace {

constexpr const char* kExtension = "KHR_draco_mesh_compression";

[[noreturn]] void fail(const std::string& what, const std::string& where) {
    throw Error(ErrorKind::Input, what, where, "copy or export the model again");
}

// What the largest number of a type stands for where the file says that it is normalised.
float largest_of(draco::DataType type) {
    switch (type) {
        case draco::DT_INT8: return 127;
        case draco::DT_UINT8: return 255;
        case draco::DT_INT16: return 32767;
        case draco::DT_UINT16: return 65535;
        default: return 1;
    }
}

std::unique_ptr<draco::Mesh> decode(std::string_view bytes, const std::string& where) {
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data(), bytes.size());
    draco::Decoder decoder;
    try {
        auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
        if (!decoded.ok())
            fail(
                fmt::format("the Draco data are damaged ({})", decoded.status().error_msg_string()),
                where);
        return std::move(decoded).value();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        fail(fmt::format("the Draco data are damaged ({})", error.what()), where);
    }
}

}  // namespace

bool is_draco(const tinygltf::Primitive& primitive) {
    return find_extension(primitive.extensions, kExtension) != nullptr;
}

DracoMesh::DracoMesh(const GltfDocument& document, const tinygltf::Primitive& primitive,
                     const std::string& where)
    : where_(where) {
    const tinygltf::Value* extension = find_extension(primitive.extensions, kExtension);
    if (!extension) fail("the Draco data are missing", where);
    const tinygltf::Value* attributes = find_value(*extension, "attributes");
    if (attributes && attributes->IsObject())
        for (const std::string& name : attributes->Keys())
            if (const int id = index_in(*attributes, name.c_str(), -1); id >= 0)
                ids_[name] = static_cast<uint32_t>(id);
    mesh_ = decode(bytes_of_view(document, index_in(*extension, "bufferView", -1), where), where);
}

DracoMesh::~DracoMesh() = default;

std::vector<float> DracoMesh::numbers_of(const std::string& attribute,
                                         const tinygltf::Accessor& accessor) const {
    const draco::PointAttribute* values = mesh_->GetAttributeByUniqueId(ids_.at(attribute));
    const int components = components_of(accessor);
    if (!values || components < 1 || components > 4)
        fail(fmt::format("the Draco data have no {}", attribute), where_);
    if (mesh_->num_points() != accessor.count)
        fail(fmt::format("the Draco data have {} vertices of {}", mesh_->num_points(),
                         accessor.count),
             where_);
    const bool scales = accessor.normalized && !values->normalized();
    const float largest = scales ? largest_of(values->data_type()) : 1;
    std::vector<float> numbers(accessor.count * static_cast<size_t>(components));
    for (uint32_t i = 0; i < mesh_->num_points(); ++i) {
        float* out = numbers.data() + i * static_cast<size_t>(components);
        const auto index = values->mapped_index(draco::PointIndex(i));
        if (index.value() >= values->size() ||
            !values->ConvertValue<float>(index, static_cast<int8_t>(components), out))
            fail(fmt::format("the Draco data of {} are damaged", attribute), where_);
        for (int c = 0; c < components; ++c)
            out[c] /= largest;
    }
    return numbers;
}

std::vector<uint32_t> DracoMesh::indices() const {
    std::vector<uint32_t> indices;
    indices.reserve(size_t{mesh_->num_faces()} * 3);
    for (uint32_t f = 0; f < mesh_->num_faces(); ++f)
        for (const draco::PointIndex& corner : mesh_->face(draco::FaceIndex(f)))
            indices.push_back(corner.value());
    return indices;
}

}  // namespace tp
