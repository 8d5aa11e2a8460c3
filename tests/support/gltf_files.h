// Small glTF files for tests: JSON written in the test, buffers made in the test.
#pragma once

#include "temporary_folder.h"

#include <teapath/core/error.h>
#include <teapath/io/model_file.h>

#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace tp::test {

inline std::string base64(const std::string& bytes) {
    const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t bits = 0;
        for (size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

template <class T>
std::string bytes_of_list(const std::vector<T>& list) {
    std::string bytes(list.size() * sizeof(T), '\0');
    if (!list.empty()) std::memcpy(bytes.data(), list.data(), bytes.size());
    return bytes;
}

/// The buffer and buffer views of a file, from pieces of 4 bytes' alignment.
class GltfBuffer {
public:
    /// Returns the number of the view.
    int add(std::string piece, int stride = 0) {
        views_ += (count_ ? ", " : "") + std::string("{\"buffer\": 0, \"byteOffset\": ") +
                  std::to_string(bytes.size()) +
                  ", \"byteLength\": " + std::to_string(piece.size()) +
                  (stride ? ", \"byteStride\": " + std::to_string(stride) : "") + "}";
        bytes += piece;
        bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
        return count_++;
    }
    std::string views() const { return "\"bufferViews\": [" + views_ + "]"; }
    /// Both lists, with the data in the URI.
    std::string json() const {
        return "\"buffers\": [{\"byteLength\": " + std::to_string(bytes.size()) +
               ", \"uri\": \"data:application/octet-stream;base64," + base64(bytes) + "\"}], " +
               views();
    }
    std::string bytes;

private:
    std::string views_;
    int count_ = 0;
};

inline std::string glb(std::string json, std::string binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const auto word = [](size_t value) {
        return bytes_of_list(std::vector<uint32_t>{static_cast<uint32_t>(value)});
    };
    return "glTF" + word(2) + word(28 + json.size() + binary.size()) + word(json.size()) + "JSON" +
           json + word(binary.size()) + std::string("BIN\0", 4) + binary;
}

struct ModelFolder : TemporaryFolder {
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path / name, std::ios::binary) << bytes;
        return path / name;
    }
    ModelContent read(const std::string& name, const std::string& bytes,
                      const ModelReadOptions& options = {}) const {
        return read_model(write(name, bytes), options);
    }
    /// The same for the JSON of a glTF file, without its braces and asset.
    ModelContent gltf(const std::string& json) const {
        return read("a.gltf", "{\"asset\": {\"version\": \"2.0\"}, " + json + "}");
    }
    /// What the refusal of such a file says.
    std::string refusal(const std::string& name, const std::string& bytes) const {
        try {
            read(name, bytes);
        } catch (const Error& error) {
            CHECK(error.kind() == ErrorKind::Input);
            CHECK(error.where().find(name) != std::string::npos);
            CHECK(error.remedy() != "");
            return error.what();
        }
        return "not refused";
    }
    std::string gltf_refusal(const std::string& json) const {
        return refusal("a.gltf", "{\"asset\": {\"version\": \"2.0\"}, " + json + "}");
    }
};

/// A triangle in the xy plane as accessors 0 (positions) and 1 (texture coordinates), mesh 0.
inline std::string triangle_json(const std::string& nodes, const std::string& primitive = "",
                                 const std::string& rest = "") {
    GltfBuffer buffer;
    buffer.add(bytes_of_list<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    buffer.add(bytes_of_list<float>({0, 1, 1, 1, 0, 0}));
    return buffer.json() +
           R"(, "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
              {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
              "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1})" +
           primitive + R"(}]}], "nodes": [)" + nodes + "]" + rest;
}

inline const Mesh& mesh_of(const Object& object) {
    return *std::get<MeshShape>(object.shape).file.mesh;
}

inline DoubleMat4 placed(const Object& object) {
    return world_from_object(object.transform) *
           DoubleMat4(std::get<MeshShape>(object.shape).placement);
}

inline bool says(const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
}

}  // namespace tp::test
