#include "gltf_mesh.h"

#include "gltf_accessor.h"
#include "gltf_draco.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace tp {
namespace {

int attribute_of(const tinygltf::Primitive& primitive, const std::string& name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

class PrimitiveReader {
public:
    PrimitiveReader(const GltfDocument& document, const tinygltf::Primitive& primitive,
                    const std::string& where)
        : document_(document), primitive_(primitive), where_(where) {}

    Mesh read(SkinWeights* skin) {
        const int positions = attribute_of(primitive_, "POSITION");
        if (positions < 0) fail("the primitive has no positions");
        if (is_draco(primitive_)) draco_.emplace(document_, primitive_, where_);
        mesh_.positions = vectors<Float3>("POSITION", positions);
        if (const int normals = attribute_of(primitive_, "NORMAL"); normals >= 0)
            mesh_.normals = attribute<Float3>("NORMAL", normals, "normals");
        if (const int tangents = attribute_of(primitive_, "TANGENT"); tangents >= 0)
            mesh_.tangents = attribute<Float4>("TANGENT", tangents, "tangents");
        for (int set = 0; set < kMostUvSets; ++set) {
            const std::string name = fmt::format("TEXCOORD_{}", set);
            const int uvs = attribute_of(primitive_, name);
            if (uvs < 0) break;
            mesh_.uvs.push_back(attribute<Float2>(name, uvs, "texture coordinates"));
        }
        if (const int colors = attribute_of(primitive_, "COLOR_0"); colors >= 0)
            read_colors(colors);
        read_triangles();
        if (skin) read_skin(*skin);
        return std::move(mesh_);
    }

private:
    static constexpr int kMostUvSets = 8, kMostSkinSets = 4;

    [[noreturn]] void fail(const std::string& what) const {
        throw Error(ErrorKind::Input, what, where_, "export the model again");
    }

    void check_count(size_t count, const char* what) const {
        if (count != mesh_.positions.size())
            fail(fmt::format("{} {} for {} vertices", count, what, mesh_.positions.size()));
    }

    template <class Vector>
    std::vector<Vector> attribute(const std::string& name, int accessor, const char* what) const {
        check_count(checked_accessor(document_, accessor, where_).count, what);
        return vectors<Vector>(name, accessor);
    }

    // From the compressed data, if it is among them.
    template <class Vector>
    std::vector<Vector> vectors(const std::string& name, int accessor) const {
        if (!draco_ || !draco_->has(name)) return read_vectors<Vector>(document_, accessor, where_);
        const tinygltf::Accessor& a = checked_accessor(document_, accessor, where_);
        if (components_of(a) != Vector::length())
            fail(fmt::format("{} has not {} numbers for each vertex", name, Vector::length()));
        const std::vector<float> numbers = draco_->numbers_of(name, a);
        std::vector<Vector> read(a.count);
        std::copy(numbers.begin(), numbers.end(), reinterpret_cast<float*>(read.data()));
        return read;
    }

    void read_colors(int accessor) {
        if (components_of(checked_accessor(document_, accessor, where_)) == 4) {
            mesh_.colors = attribute<Float4>("COLOR_0", accessor, "colours");
            return;
        }
        const std::vector<Float3> colors = attribute<Float3>("COLOR_0", accessor, "colours");
        mesh_.colors.reserve(colors.size());
        for (const Float3& color : colors)
            mesh_.colors.emplace_back(color, 1);
    }

    void read_skin(SkinWeights& skin) const {
        for (int set = 0; set < kMostSkinSets; ++set) {
            const std::string joints = fmt::format("JOINTS_{}", set);
            const std::string weights = fmt::format("WEIGHTS_{}", set);
            const int j = attribute_of(primitive_, joints), w = attribute_of(primitive_, weights);
            if (j < 0 || w < 0) return;
            skin.joints.push_back(attribute<Float4>(joints, j, "joints"));
            skin.weights.push_back(attribute<Float4>(weights, w, "weights"));
        }
    }

    void read_triangles() {
        std::vector<uint32_t> corners;
        if (draco_) {
            corners = draco_->indices();
        } else if (primitive_.indices >= 0) {
            corners = read_indices(document_, primitive_.indices, where_);
        } else {
            corners.resize(mesh_.positions.size());
            for (size_t i = 0; i < corners.size(); ++i)
                corners[i] = static_cast<uint32_t>(i);
        }
        const size_t count = corners.size();
        if (primitive_.mode == TINYGLTF_MODE_TRIANGLES) {
            mesh_.triangles.reserve(count / 3);
            for (size_t i = 0; i + 3 <= count; i += 3)
                mesh_.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
            return;
        }
        // Two equal corners in a strip only lead to its next part.
        for (size_t i = 2; i < count; ++i) {
            const bool is_fan = primitive_.mode == TINYGLTF_MODE_TRIANGLE_FAN;
            const uint32_t a = is_fan ? corners[0] : corners[i - 2 + i % 2];
            const uint32_t b = is_fan ? corners[i - 1] : corners[i - 1 - i % 2];
            const uint32_t c = corners[i];
            if (a != b && b != c && c != a) mesh_.triangles.push_back({a, b, c});
        }
    }

    const GltfDocument& document_;
    const tinygltf::Primitive& primitive_;
    const std::string& where_;
    std::optional<DracoMesh> draco_;
    Mesh mesh_;
};

}  // namespace

Mesh read_primitive(const GltfDocument& document, const tinygltf::Primitive& primitive,
                    const std::string& where, SkinWeights* skin) {
    return PrimitiveReader(document, primitive, where).read(skin);
}

double bytes_of_primitive(const GltfDocument& document, const tinygltf::Primitive& primitive,
                          const std::string& where) {
    double bytes = 0, vertices = 0;
    for (const auto& [name, accessor] : primitive.attributes) {
        const tinygltf::Accessor& a = checked_accessor(document, accessor, where);
        const auto count = static_cast<double>(a.count);
        bytes += count * 4 * components_of(a);
        if (name == "POSITION") vertices = count;
    }
    double corners = vertices;
    if (primitive.indices >= 0)
        corners = static_cast<double>(checked_accessor(document, primitive.indices, where).count);
    // The corners once as they are read, once as triangles: 12 bytes each in a strip.
    return bytes + corners * (primitive.mode == TINYGLTF_MODE_TRIANGLES ? 8 : 16);
}

bool has_triangles(const tinygltf::Primitive& primitive) {
    return primitive.mode == TINYGLTF_MODE_TRIANGLES ||
           primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
           primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

}  // namespace tp
