#include "mesh_finish.h"
#include "mesh_readers.h"
#include "ply_body.h"
#include "polygon.h"

#include <teapath/core/color.h>
#include <teapath/core/error.h>

#include <fmt/format.h>

#include <utility>

namespace tp {
namespace {

// Where a property of a vertex goes: component `component` of a list of the mesh.
struct Target {
    const PlyProperty* property;
    float* values;  // of the first vertex
    size_t stride;  // floats from one vertex to the next
    bool is_srgb = false;
};

// Whole numbers of colours are shares of the largest, and all but alpha are sRGB.
double color_scale(PlyType type) {
    switch (type) {
        case PlyType::F32:
        case PlyType::F64: return 1;
        case PlyType::I8:
        case PlyType::U8: return 1.0 / 255;
        case PlyType::I16:
        case PlyType::U16: return 1.0 / 65535;
        case PlyType::I32:
        case PlyType::U32: break;
    }
    return 1.0 / 255;  // some write bytes into wide numbers
}

class PlyReader {
public:
    PlyReader(std::string_view bytes, const std::string& name)
        : name_(name), header_(parse_ply_header(bytes, name)), body_(bytes, header_, name) {}

    Mesh read() {
        for (const PlyElement& element : header_.elements) {
            if (element.count > kMaxMeshCount)
                throw Error(
                    ErrorKind::Input,
                    fmt::format("{} rows of \"{}\" are too many", element.count, element.name),
                    name_, "at most 2,147,483,648");
            body_.begin(element);
            if (element.name == "vertex" && mesh_.positions.empty())
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element);
            else
                skip(element);
        }
        return finish_mesh(std::move(mesh_), name_);
    }

private:
    void skip(const PlyElement& element) {
        if (element.properties.empty()) return;
        for (uint64_t row = 0; row < element.count; ++row) {
            body_.set_row(row);
            body_.skip_row(element);
        }
    }

    // Makes the lists that the properties fill, and says which goes where.
    std::vector<Target> targets_of(const PlyElement& element) {
        const auto count = static_cast<size_t>(element.count);
        std::vector<Target> targets;
        const auto add = [&](auto& list, std::initializer_list<const char*> names) {
            for (const char* property : names)
                if (const PlyProperty* found = element.find(property); !found || found->is_list)
                    return false;
            using Vector = typename std::remove_reference_t<decltype(list)>::value_type;
            list.resize(count, Vector(1));
            float* values = &list[0][0];
            for (const char* property : names)
                targets.push_back(
                    {element.find(property), values++, static_cast<size_t>(Vector::length())});
            return true;
        };
        if (!add(mesh_.positions, {"x", "y", "z"}))
            throw Error(ErrorKind::Input, "the vertices have no x, y and z", name_,
                        "export the mesh again");
        add(mesh_.normals, {"nx", "ny", "nz"});
        for (const auto& [u, v] : {std::pair{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}}) {
            mesh_.uvs.emplace_back();
            if (add(mesh_.uvs.back(), {u, v})) break;
            mesh_.uvs.pop_back();
        }
        const size_t before = targets.size();
        if (!add(mesh_.colors, {"red", "green", "blue", "alpha"}))
            add(mesh_.colors, {"red", "green", "blue"});
        for (size_t i = before; i < targets.size(); ++i)
            targets[i].is_srgb = i - before < 3;
        first_color_ = before;
        return targets;
    }

    void read_vertices(const PlyElement& element) {
        if (element.count == 0) return;
        const std::vector<Target> targets = targets_of(element);
        if (body_.is_ascii() || element.has_lists)
            read_rows(element, targets);
        else
            read_columns(element, targets);
        for (size_t i = first_color_; i < targets.size(); ++i)
            decode_color(targets[i]);
        if (!mesh_.uvs.empty()) flip_v(mesh_.uvs[0]);
    }

    // Rows of equal length: each column in a loop of its own, without a switch inside.
    void read_columns(const PlyElement& element, const std::vector<Target>& targets) {
        const char* rows = body_.take_rows(element);
        const bool swap = body_.swaps();
        for (const Target& target : targets)
            with_ply_type(target.property->type, [&](auto zero) {
                const char* from = rows + target.property->offset;
                float* to = target.values;
                for (uint64_t i = 0; i < element.count; ++i) {
                    *to = static_cast<float>(load_ply<decltype(zero)>(from, swap));
                    from += element.row_bytes;
                    to += target.stride;
                }
            });
    }

    void read_rows(const PlyElement& element, const std::vector<Target>& targets) {
        std::vector<const Target*> target_of(element.properties.size());
        for (const Target& target : targets)
            target_of[static_cast<size_t>(target.property - element.properties.data())] = &target;
        for (uint64_t row = 0; row < element.count; ++row) {
            body_.set_row(row);
            for (size_t i = 0; i < element.properties.size(); ++i) {
                const PlyProperty& property = element.properties[i];
                if (property.is_list) {
                    body_.skip_values(property.type, body_.next_length(property));
                    continue;
                }
                const auto value = body_.next<double>(property.type);
                if (target_of[i])
                    target_of[i]->values[row * target_of[i]->stride] = static_cast<float>(value);
            }
        }
    }

    void decode_color(const Target& target) {
        const auto scale = static_cast<float>(color_scale(target.property->type));
        const bool is_float =
            target.property->type == PlyType::F32 || target.property->type == PlyType::F64;
        float* value = target.values;
        for (size_t i = 0; i < mesh_.colors.size(); ++i, value += target.stride) {
            *value *= scale;
            if (target.is_srgb && !is_float) *value = linear_from_srgb(*value);
        }
    }

    void read_faces(const PlyElement& element) {
        const PlyProperty* indices = element.find("vertex_indices");
        if (!indices) indices = element.find("vertex_index");
        if (!indices || !indices->is_list) return skip(element);
        // Triangles mostly; the file holds at least one byte for each.
        mesh_.triangles.reserve(mesh_.triangles.size() + static_cast<size_t>(element.count));
        for (uint64_t row = 0; row < element.count; ++row) {
            body_.set_row(row);
            for (const PlyProperty& property : element.properties) {
                const uint64_t length = property.is_list ? body_.next_length(property) : 1;
                if (&property == indices)
                    read_polygon(property, length);
                else
                    body_.skip_values(property.type, length);
            }
        }
    }

    void read_polygon(const PlyProperty& indices, uint64_t length) {
        uint32_t few[3];
        const size_t vertices = mesh_.positions.size();
        if (length > 3) {
            corners_.resize(length);
            places_.resize(length);
        }
        for (uint64_t i = 0; i < length; ++i) {
            const auto index = body_.next<int64_t>(indices.type);
            if (index < 0 || static_cast<uint64_t>(index) >= vertices)
                body_.fail(fmt::format("index {} is not one of the {} vertices", index, vertices));
            const auto vertex = static_cast<uint32_t>(index);
            if (length <= 3) {
                few[i] = vertex;
            } else {
                corners_[i] = vertex;
                places_[i] = mesh_.positions[vertex];
            }
        }
        if (length == 3)
            mesh_.triangles.push_back({few[0], few[1], few[2]});
        else if (length > 3)
            cutter_.cut(places_.data(), corners_.data(), corners_.size(), mesh_.triangles);
    }

    const std::string& name_;
    PlyHeader header_;
    PlyBody body_;
    Mesh mesh_;
    size_t first_color_ = 0;  // among the targets
    PolygonCutter cutter_;
    std::vector<uint32_t> corners_;
    std::vector<Float3> places_;
};

}  // namespace

Mesh read_ply(std::string_view bytes, const std::string& name) {
    return PlyReader(bytes, name).read();
}

}  // namespace tp
