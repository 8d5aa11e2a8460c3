#include "gltf_meshopt.h"

#include "gltf_value.h"

#include <teapath/core/error.h>
#include <teapath/core/parallel.h>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <string_view>
#include <vector>

namespace tp {
namespace {

// What the extension says of one view.
struct Compressed {
    size_t view;
    std::string_view bytes;
    size_t count, stride;
    std::string mode, filter;
};

std::string text_in(const tinygltf::Value& object, const char* key, const char* absent) {
    const tinygltf::Value* value = find_value(object, key);
    return value && value->IsString() ? value->Get<std::string>() : absent;
}

size_t size_in(const tinygltf::Value& object, const char* key, const std::string& where) {
    const int value = index_in(object, key, 0);
    if (value < 0)
        throw Error(ErrorKind::Input, fmt::format("{} is below 0", key), where,
                    "export the model again");
    return static_cast<size_t>(value);
}

// The library takes these for granted.
bool has_sound_sizes(const Compressed& c) {
    if (c.mode == "ATTRIBUTES") {
        if (c.stride == 0 || c.stride > 256 || c.stride % 4 != 0) return false;
        if (c.filter == "OCTAHEDRAL") return c.stride == 4 || c.stride == 8;
        if (c.filter == "QUATERNION") return c.stride == 8;
        return c.filter == "NONE" || c.filter == "EXPONENTIAL";
    }
    const bool is_index = c.stride == 2 || c.stride == 4;
    if (c.mode == "TRIANGLES") return is_index && c.count % 3 == 0;
    return c.mode == "INDICES" && is_index;
}

Compressed read_description(const GltfDocument& document, size_t view, const tinygltf::Value& e) {
    const std::string where = document.place("bufferViews", view);
    Compressed c;
    c.view = view;
    c.count = size_in(e, "count", where);
    c.stride = size_in(e, "byteStride", where);
    c.mode = text_in(e, "mode", "");
    c.filter = text_in(e, "filter", "NONE");
    const size_t buffer = size_in(e, "buffer", where);
    const size_t offset = size_in(e, "byteOffset", where);
    const size_t length = size_in(e, "byteLength", where);
    const bool is_inside = buffer < document.buffers.size() &&
                           offset <= document.buffers[buffer].size() &&
                           length <= document.buffers[buffer].size() - offset;
    if (!is_inside || !has_sound_sizes(c))
        throw Error(ErrorKind::Input, "the compressed view is not as it should be", where,
                    "export the model again");
    c.bytes = document.buffers[buffer].substr(offset, length);
    return c;
}

std::string decode(const Compressed& c, const std::string& where) {
    std::string decoded(c.count * c.stride, '\0');
    const auto* bytes = reinterpret_cast<const unsigned char*>(c.bytes.data());
    const size_t size = c.bytes.size();
    const int problem =
        c.mode == "ATTRIBUTES"
            ? meshopt_decodeVertexBuffer(decoded.data(), c.count, c.stride, bytes, size)
        : c.mode == "TRIANGLES"
            ? meshopt_decodeIndexBuffer(decoded.data(), c.count, c.stride, bytes, size)
            : meshopt_decodeIndexSequence(decoded.data(), c.count, c.stride, bytes, size);
    if (problem != 0)
        throw Error(ErrorKind::Input, "the compressed view is damaged", where,
                    "copy or export the model again");
    if (c.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(decoded.data(), c.count, c.stride);
    if (c.filter == "QUATERNION") meshopt_decodeFilterQuat(decoded.data(), c.count, c.stride);
    if (c.filter == "EXPONENTIAL") meshopt_decodeFilterExp(decoded.data(), c.count, c.stride);
    return decoded;
}

}  // namespace

void decode_meshopt_views(GltfDocument& document) {
    const auto& views = document.model.bufferViews;
    std::vector<Compressed> compressed;
    double bytes = 0;
    for (size_t i = 0; i < views.size(); ++i)
        if (const auto* e = find_extension(views[i].extensions, "EXT_meshopt_compression")) {
            compressed.push_back(read_description(document, i, *e));
            bytes += static_cast<double>(compressed.back().count) *
                     static_cast<double>(compressed.back().stride);
        }
    check_memory(*document.source, bytes);
    document.decoded.resize(views.size());
    shared_pool().for_each(static_cast<int64_t>(compressed.size()), [&](int64_t i) {
        const Compressed& c = compressed[static_cast<size_t>(i)];
        document.decoded[c.view] = decode(c, document.place("bufferViews", c.view));
    });
}

}  // namespace tp
