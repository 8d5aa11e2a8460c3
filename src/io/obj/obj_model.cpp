#include "obj_model.h"

#include "../mesh/mesh_finish.h"
#include "../mesh/obj_text.h"
#include "obj_materials.h"

#include <teapath/core/error.h>

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace tp {
namespace fs = std::filesystem;

namespace {

class ObjReader {
public:
    ObjReader(std::string_view bytes, const ModelSource& source)
        : bytes_(bytes), source_(source), textures_(source, content_), progress_(source) {}

    ModelContent read() {
        constexpr size_t kBytesOfLine = 30;
        progress_.begin(0.5, bytes_.size() / (kBytesOfLine * kObjTick) + 1);
        const ObjText text = parse_obj(bytes_, source_.name, [this] { progress_.step(); });
        read_libraries(text);
        add_objects(text);
        textures_.load_images(progress_);
        take_off_heights();
        if (text.lines_and_points > 0)
            say("Points and lines cannot be shown: {} of them are left out.",
                text.lines_and_points);
        return std::move(content_);
    }

private:
    template <class... Values>
    void say(fmt::format_string<Values...> text, Values&&... values) {
        content_.unsupported.push_back(fmt::format(text, std::forward<Values>(values)...));
    }

    // A line may name several files, or one with spaces in its name.
    void read_libraries(const ObjText& text) {
        for (const std::string& line : text.libraries) {
            if (read_library(line)) continue;
            std::istringstream names(line);
            for (std::string name; names >> name;)
                if (!read_library(name))
                    say("Material library {} is missing, or lies outside the model's folder.",
                        name);
        }
    }

    bool read_library(const std::string& name) {
        if (const auto known = libraries_.find(name); known != libraries_.end())
            return known->second;
        bool& is_read = libraries_[name];
        try {
            read_mtl(read_beside(source_, name, "a material library (.mtl)", source_.name),
                     materials_);
            is_read = true;
        } catch (const Error&) {
            is_read = false;
        }
        return is_read;
    }

    void add_objects(const ObjText& text) {
        std::map<std::string, size_t> parts_of_group;
        for (const ObjPart& part : text.parts)
            ++parts_of_group[part.group];
        std::map<std::string, size_t> numbers;
        std::vector<Mesh> meshes = meshes_of(text);
        UniqueNames paths;
        for (size_t i = 0; i < meshes.size(); ++i) {
            const ObjPart& part = text.parts[i];
            if (meshes[i].triangles.empty()) continue;
            std::string name = part.group.empty() ? stem() : part.group.substr(0, 200);
            if (parts_of_group[part.group] > 1) name += fmt::format(".{}", ++numbers[part.group]);
            Object object;
            object.id = ObjectId{static_cast<uint32_t>(content_.objects.size() + 1)};
            object.name = object.part.path = paths.add(name);
            MeshShape shape;
            shape.file = {fmt::format("{}#part/{}", fs::path(source_.name).filename().string(), i),
                          share(finish_mesh(std::move(meshes[i]), source_.name))};
            object.shape = std::move(shape);
            object.material = id_of(part.material);
            content_.objects.push_back(std::move(object));
        }
        if (content_.objects.empty())
            throw Error(ErrorKind::Input, "there are no triangles in it", source_.name,
                        "points and lines alone cannot be shown");
    }

    MaterialId id_of(const std::string& name) {
        const auto [entry, is_new] = ids_.try_emplace(name);
        if (!is_new) return entry->second;
        const auto source = materials_.find(name);
        Material m;
        if (source != materials_.end()) {
            m = material_of(source->second, textures_);
        } else {
            m.kind = MaterialKind::Principled;
            m.color.color = Double3(0.8);
            if (!name.empty()) say("Material \"{}\" is not described; it is grey.", name);
        }
        m.id = entry->second = MaterialId{static_cast<uint32_t>(content_.materials.size() + 1)};
        m.name = m.part.path = material_paths_.add(name.empty() ? "default" : path_piece(name));
        content_.materials.push_back(std::move(m));
        return entry->second;
    }

    void take_off_heights() {
        bool is_said = false;
        for (Material& m : content_.materials) {
            if (!textures_.is_grey(m.surface.normal)) continue;
            m.surface.normal = {};
            if (!std::exchange(is_said, true))
                say("Bump maps of heights are left out; normal maps are shown.");
        }
    }

    std::string stem() const { return path_piece(fs::path(source_.name).stem().string()); }

    std::string_view bytes_;
    const ModelSource& source_;
    ModelContent content_;
    ObjTextures textures_;
    ModelProgress progress_;
    std::map<std::string, bool> libraries_;
    std::map<std::string, MtlMaterial> materials_;
    std::map<std::string, MaterialId> ids_;
    UniqueNames material_paths_;
};

}  // namespace

ModelContent read_obj_model(std::string_view bytes, const ModelSource& source) {
    return ObjReader(bytes, source).read();
}

}  // namespace tp
