#include "gltf_container.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <cstdint>

namespace tp {
namespace {

constexpr uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

uint32_t little_32(std::string_view bytes, size_t at) {
    uint32_t value = 0;
    for (size_t i = 0; i < 4; ++i)
        value |= uint32_t{static_cast<uint8_t>(bytes[at + i])} << 8 * i;
    return value;
}

}  // namespace

GltfContainer open_container(std::string_view bytes, const std::string& name) {
    if (!bytes.starts_with("glTF")) return {bytes, {}};
    if (bytes.size() < 20)
        throw Error(ErrorKind::Input, "the file is cut short", name, "copy or export it again");
    if (const uint32_t version = little_32(bytes, 4); version != 2)
        throw Error(ErrorKind::Input, fmt::format("this is glTF binary version {}", version), name,
                    "version 2 can be read: export the model again");
    if (little_32(bytes, 8) > bytes.size())
        throw Error(ErrorKind::Input, "the file is shorter than it says", name,
                    "it may be cut short: copy or export it again");

    // Chunks: length, type, bytes; unknown ones are skipped.
    GltfContainer container;
    for (size_t at = 12; at + 8 <= bytes.size();) {
        const size_t length = little_32(bytes, at);
        const uint32_t type = little_32(bytes, at + 4);
        if (length > bytes.size() - at - 8)
            throw Error(ErrorKind::Input, "a part of the file is longer than the file", name,
                        "it may be cut short: copy or export it again");
        if (type == kJsonChunk && container.json.empty())
            container.json = bytes.substr(at + 8, length);
        else if (type == kBinaryChunk && !container.binary)
            container.binary = bytes.substr(at + 8, length);
        at += 8 + length;
    }
    if (container.json.empty())
        throw Error(ErrorKind::Input, "the file has no JSON part", name, "export the model again");
    return container;
}

}  // namespace tp
