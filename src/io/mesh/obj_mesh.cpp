// Faces of an OBJ file as indexed triangles: a vertex for each different corner.
#include "mesh_finish.h"
#include "mesh_readers.h"
#include "obj_text.h"
#include "polygon.h"

#include <algorithm>
#include <utility>

namespace tp {
namespace {

// Keeps a table of the file's positions between parts, of which there may be thousands.
class Mesher {
public:
    explicit Mesher(const ObjText& text) : text_(text), first_(text.positions.size(), kNoIndex) {}

    Mesh mesh_of(const std::vector<const ObjPart*>& parts) {
        begin(parts);
        for (const ObjPart* part : parts)
            add(*part);
        for (const ObjPart* part : parts)
            for (const ObjCorner& corner : part->corners)
                first_[corner.position] = kNoIndex;
        return std::move(mesh_);
    }

private:
    void begin(const std::vector<const ObjPart*>& parts) {
        mesh_ = {};
        vertices_.clear();
        has_uvs_ = has_normals_ = false;
        size_t corners = 0, faces = 0;
        for (const ObjPart* part : parts) {
            corners += part->corners.size();
            faces += part->sizes.size();
            for (const ObjCorner& corner : part->corners) {
                has_uvs_ |= corner.uv != kNoIndex;
                has_normals_ |= corner.normal != kNoIndex;
            }
        }
        mesh_.triangles.reserve(corners - 2 * faces);  // each face has three corners or more
        mesh_.positions.reserve(std::min(corners, text_.positions.size()));
        if (has_uvs_) mesh_.uvs.emplace_back();
    }

    void add(const ObjPart& part) {
        const ObjCorner* corner = part.corners.data();
        for (const uint32_t size : part.sizes) {
            indices_.resize(size);
            places_.resize(size);
            for (uint32_t i = 0; i < size; ++i) {
                indices_[i] = vertex_of(corner[i]);
                places_[i] = text_.positions[corner[i].position];
            }
            cutter_.cut(places_.data(), indices_.data(), size, mesh_.triangles);
            corner += size;
        }
    }

    // Vertices of the same position are a chain, which is short.
    uint32_t vertex_of(const ObjCorner& corner) {
        uint32_t* link = &first_[corner.position];
        while (*link != kNoIndex) {
            Vertex& vertex = vertices_[*link];
            if (vertex.uv == corner.uv && vertex.normal == corner.normal) return *link;
            link = &vertex.next;
        }
        const auto index = static_cast<uint32_t>(vertices_.size());
        *link = index;
        vertices_.push_back({corner.uv, corner.normal, kNoIndex});
        mesh_.positions.push_back(text_.positions[corner.position]);
        if (has_uvs_)
            mesh_.uvs[0].push_back(corner.uv == kNoIndex ? Float2(0) : text_.uvs[corner.uv]);
        if (has_normals_)
            mesh_.normals.push_back(corner.normal == kNoIndex ? Float3(0)
                                                              : text_.normals[corner.normal]);
        if (!text_.colors.empty()) mesh_.colors.push_back(text_.colors[corner.position]);
        return index;
    }

    struct Vertex {
        uint32_t uv, normal;
        uint32_t next;  // of the same position
    };

    const ObjText& text_;
    Mesh mesh_;
    bool has_uvs_ = false, has_normals_ = false;
    std::vector<uint32_t> first_;  // vertex of each position
    std::vector<Vertex> vertices_;
    PolygonCutter cutter_;
    std::vector<uint32_t> indices_;
    std::vector<Float3> places_;
};

}  // namespace

std::vector<Mesh> meshes_of(const ObjText& text) {
    Mesher mesher(text);
    std::vector<Mesh> meshes;
    for (const ObjPart& part : text.parts)
        meshes.push_back(mesher.mesh_of({&part}));
    return meshes;
}

Mesh read_obj(std::string_view bytes, const std::string& name) {
    const ObjText text = parse_obj(bytes, name, {});
    std::vector<const ObjPart*> parts;
    for (const ObjPart& part : text.parts)
        parts.push_back(&part);
    return finish_mesh(Mesher(text).mesh_of(parts), name);
}

}  // namespace tp
