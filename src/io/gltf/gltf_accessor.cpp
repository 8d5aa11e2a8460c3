#include "gltf_accessor.h"

#include "../mesh/mesh_finish.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace tp {
namespace {

// Without a buffer view a few bytes of a file would ask for any amount of zeros.
constexpr size_t kMostZeros = size_t{1} << 24;
constexpr size_t kMostStride = 4096;

[[noreturn]] void fail(const std::string& what, const std::string& where) {
    throw Error(ErrorKind::Input, what, where, "export the model again");
}

size_t component_bytes(int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT: return 4;
        default: return 0;
    }
}

// Elements in memory, `stride` bytes apart.
struct Elements {
    const char* data = nullptr;  // null: zeros
    size_t stride = 0;
    size_t count = 0;
};

// `count` elements of `size` bytes from a byte of a view on; they must lie inside it.
Elements elements_of(const GltfDocument& document, int view, size_t offset, size_t count,
                     size_t size, bool packed, const std::string& where) {
    const std::string_view bytes = bytes_of_view(document, view, where);
    const size_t said = document.model.bufferViews[static_cast<size_t>(view)].byteStride;
    const size_t stride = packed || said == 0 ? size : said;
    if (stride < size || stride > kMostStride)
        fail(fmt::format("a stride of {} bytes does not suit elements of {}", stride, size), where);
    if (count > 0 && (offset > bytes.size() || bytes.size() - offset < size ||
                      (bytes.size() - offset - size) / stride < count - 1))
        fail(fmt::format("{} elements of {} bytes reach beyond the {} bytes of buffer view {}",
                         count, stride, bytes.size(), view),
             where);
    return {bytes.data() + offset, stride, count};
}

template <class T>
T read(const char* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

template <class T>
void convert(const Elements& elements, size_t components, float largest, float* out) {
    for (size_t i = 0; i < elements.count; ++i) {
        const char* at = elements.data + i * elements.stride;
        for (size_t c = 0; c < components; ++c, ++out, at += sizeof(T)) {
            *out = static_cast<float>(read<T>(at)) / largest;
            if (std::is_integral_v<T> && std::is_signed_v<T> && largest != 1)
                *out = std::max(*out, -1.0f);
        }
    }
}

void convert(const tinygltf::Accessor& a, const Elements& elements, size_t components, float* out) {
    if (!elements.data) {
        std::fill_n(out, elements.count * components, 0.0f);
        return;
    }
    const auto scaled = [&](float largest) { return a.normalized ? largest : 1.0f; };
    switch (a.componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return convert<int8_t>(elements, components, scaled(127), out);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return convert<uint8_t>(elements, components, scaled(255), out);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return convert<int16_t>(elements, components, scaled(32767), out);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return convert<uint16_t>(elements, components, scaled(65535), out);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return convert<uint32_t>(elements, components, scaled(4294967295.0f), out);
        default: return convert<float>(elements, components, 1, out);
    }
}

void convert_indices(int type, const Elements& elements, std::vector<uint32_t>& out) {
    out.resize(elements.count);
    if (!elements.data) return;
    for (size_t i = 0; i < elements.count; ++i) {
        const char* at = elements.data + i * elements.stride;
        out[i] = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? read<uint8_t>(at)
                 : type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? read<uint16_t>(at)
                                                                  : read<uint32_t>(at);
    }
}

bool is_index_type(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

Elements elements_of(const GltfDocument& document, const tinygltf::Accessor& a,
                     const std::string& where) {
    if (a.bufferView < 0) return {nullptr, 0, a.count};
    const size_t size = component_bytes(a.componentType) * static_cast<size_t>(components_of(a));
    return elements_of(document, a.bufferView, a.byteOffset, a.count, size, false, where);
}

// Which elements a sparse accessor changes, and to what.
struct Changes {
    std::vector<uint32_t> indices;
    Elements values;
};

Changes changes_of(const GltfDocument& document, const tinygltf::Accessor& a,
                   const std::string& where) {
    const auto& sparse = a.sparse;
    Changes changes;
    if (!sparse.isSparse) return changes;
    if (sparse.count < 0 || static_cast<size_t>(sparse.count) > a.count ||
        sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 ||
        !is_index_type(sparse.indices.componentType))
        fail("the sparse part is not as it should be", where);
    const auto count = static_cast<size_t>(sparse.count);
    const auto offset = [](int bytes) { return static_cast<size_t>(bytes); };
    convert_indices(
        sparse.indices.componentType,
        elements_of(document, sparse.indices.bufferView, offset(sparse.indices.byteOffset), count,
                    component_bytes(sparse.indices.componentType), true, where),
        changes.indices);
    for (const uint32_t index : changes.indices)
        if (index >= a.count)
            fail(fmt::format("sparse index {} is beyond the {} elements", index, a.count), where);
    changes.values = elements_of(
        document, sparse.values.bufferView, offset(sparse.values.byteOffset), count,
        component_bytes(a.componentType) * static_cast<size_t>(components_of(a)), true, where);
    return changes;
}

void read_into(const GltfDocument& document, const tinygltf::Accessor& a, float* out,
               const std::string& where) {
    const auto components = static_cast<size_t>(components_of(a));
    convert(a, elements_of(document, a, where), components, out);
    const Changes changes = changes_of(document, a, where);
    for (size_t i = 0; i < changes.indices.size(); ++i) {
        const Elements one{changes.values.data + i * changes.values.stride, changes.values.stride,
                           1};
        convert(a, one, components, out + changes.indices[i] * components);
    }
}

}  // namespace

int components_of(const tinygltf::Accessor& a) {
    return tinygltf::GetNumComponentsInType(static_cast<uint32_t>(a.type));
}

const tinygltf::Accessor& checked_accessor(const GltfDocument& document, int index,
                                           const std::string& where) {
    const auto& accessors = document.model.accessors;
    if (index < 0 || static_cast<size_t>(index) >= accessors.size())
        fail(fmt::format("there is no accessor {}", index), where);
    const tinygltf::Accessor& a = accessors[static_cast<size_t>(index)];
    const std::string here = document.place("accessors", static_cast<size_t>(index));
    if (component_bytes(a.componentType) == 0)
        fail(fmt::format("there is no component type {}", a.componentType), here);
    if (a.count >= kMaxMeshCount || (a.bufferView < 0 && a.count > kMostZeros))
        fail(fmt::format("{} elements are too many", a.count), here);
    elements_of(document, a, here);
    return a;
}

std::vector<float> read_floats(const GltfDocument& document, int index, const std::string& where) {
    const tinygltf::Accessor& a = checked_accessor(document, index, where);
    std::vector<float> numbers(a.count * static_cast<size_t>(components_of(a)));
    read_into(document, a, numbers.data(), where);
    return numbers;
}

template <class Vector>
std::vector<Vector> read_vectors(const GltfDocument& document, int index,
                                 const std::string& where) {
    const tinygltf::Accessor& a = checked_accessor(document, index, where);
    if (components_of(a) != Vector::length() || a.type == TINYGLTF_TYPE_MAT2)
        fail(
            fmt::format("accessor {} has not {} numbers for each element", index, Vector::length()),
            where);
    std::vector<Vector> vectors(a.count);
    read_into(document, a, reinterpret_cast<float*>(vectors.data()), where);
    return vectors;
}

template std::vector<Float2> read_vectors(const GltfDocument&, int, const std::string&);
template std::vector<Float3> read_vectors(const GltfDocument&, int, const std::string&);
template std::vector<Float4> read_vectors(const GltfDocument&, int, const std::string&);

std::vector<uint32_t> read_indices(const GltfDocument& document, int index,
                                   const std::string& where) {
    const tinygltf::Accessor& a = checked_accessor(document, index, where);
    if (a.type != TINYGLTF_TYPE_SCALAR || !is_index_type(a.componentType))
        fail(fmt::format("accessor {} does not hold indices", index), where);
    std::vector<uint32_t> indices;
    convert_indices(a.componentType, elements_of(document, a, where), indices);
    const Changes changes = changes_of(document, a, where);
    std::vector<uint32_t> values;
    convert_indices(a.componentType, changes.values, values);
    for (size_t i = 0; i < changes.indices.size(); ++i)
        indices[changes.indices[i]] = values[i];
    return indices;
}

}  // namespace tp
