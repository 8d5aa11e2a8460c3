// The visitor of scene_fields.h that reads a JSON object into a struct, and knows where it stands.
#pragma once

#include "json_text.h"

#include <teapath/core/enum_table.h>
#include <teapath/scene/scene.h>

#include <functional>
#include <map>
#include <set>
#include <string>

namespace tp {

/// The changes of a model's things, to be read once every name is known.
struct ModelChanges {
    ModelId model;
    const Json* json;  // the model's entry
    std::string path;
};

/// Gives the content of a model file by its path in the scene file; null: there is none.
using ModelLoader = std::function<std::shared_ptr<const ModelContent>(const std::string&)>;

/// What one read shares: the scene that grows, names already given an id, the file's name.
struct ReadState {
    std::string file;
    ModelLoader load_model;
    Scene scene;
    std::map<std::string, TextureId> texture_names;
    std::map<std::string, MaterialId> material_names;
    std::vector<ModelChanges> model_changes;
    bool model_is_missing = false;  // names that are unknown may be its
    bool has_camera = false;        // the file says so
};

/// Reads the fields of one JSON object; `finish` refuses keys that nobody asked for.
class SceneReader {
public:
    /// `changes`: what is absent stays as it is, and null takes away.
    SceneReader(ReadState& state, const Json& json, std::string path, bool changes = false);

    void operator()(const char* key, bool& value);
    void operator()(const char* key, int& value);
    void operator()(const char* key, uint64_t& value);
    void operator()(const char* key, double& value);
    void operator()(const char* key, float& value);
    void operator()(const char* key, std::string& value);
    void operator()(const char* key, Double2& value);
    void operator()(const char* key, Double3& value);
    void operator()(const char* key, std::vector<Double4>& value);
    void operator()(const char* key, TexturedColor& value);
    void operator()(const char* key, TexturedNumber& value);
    void operator()(const char* key, MaterialId& value);

    template <class Enum>
    requires std::is_enum_v<Enum>
    void operator()(const char* key, Enum& value) {
        if (const Json* json = find(key)) value = enum_of<Enum>(*json, path_of(key));
    }

    void required(const char* key, std::string& value, const char* remedy);
    void color(const char* key, Double3& value);
    /// A texture or the name of one; absent where there is none.
    void texture(const char* key, TextureId& value);
    /// The path of an image; it may be empty, where none has been chosen yet.
    void image(const char* key, ImageFile& value);
    /// The same, absent where there is none.
    void optional_image(const char* key, ImageFile& value);
    /// The path of a mesh.
    void mesh(const char* key, MeshFile& value);
    /// Nine numbers, column by column; absent where it is the identity.
    void matrix(const char* key, DoubleMat3& value);
    /// A key that editors write, and that messages do not offer.
    void schema(const char* key, std::string& value);
    void kind(const char* key, TextureKind& value) { required_kind(key, value); }
    void kind(const char* key, MaterialKind& value) { required_kind(key, value); }
    void start_from(Material& value, const Material& standard) {
        if (!changes_ || json_.contains("type")) value = with_name_of(value, standard);
    }
    /// A key whose presence switches emission on.
    void glow(const char* key, bool& emits, TexturedColor& value);
    void kind(const char* key, BackgroundKind& value) { required_kind(key, value); }
    void constant(const char* key, const char* value);
    void constant(const char* key, int value);
    void shape(const char* key, Shape& value);
    void cameras(Scene& scene);
    void models(const char* key, Scene& scene);
    /// A section of a model's changes, which are read later.
    void changes(const char* key) { find(key); }
    void model_changes();
    void named(const char* key, std::vector<Texture>& textures);
    void named(const char* key, std::vector<Material>& materials);

    template <class T, class Fields>
    void object(const char* key, T& value, Fields&& fields) {
        const Json* json = find(key);
        if (!json) return;
        SceneReader inner(state_, *json, path_of(key));
        fields(inner, value);
        inner.finish();
    }

    template <class T, class Fields>
    void list(const char* key, std::vector<T>& values, Fields&& fields) {
        const Json* json = find(key);
        if (!json) return;
        expect_array(*json, path_of(key));
        for (size_t i = 0; i < json->size(); ++i) {
            SceneReader inner(state_, (*json)[i], path_of(key) + "[" + std::to_string(i) + "]");
            T value;
            value.id = {static_cast<uint32_t>(values.size()) + 1};
            fields(inner, value);
            inner.finish();
            values.push_back(std::move(value));
        }
    }

    /// Throws for the first key that was not read, with the nearest known one.
    void finish() const;

private:
    const Json* find(const char* key);
    void check_name(const std::string& name, const char* key) const;
    std::string path_of(const char* key) const { return path_.empty() ? key : path_ + "." + key; }
    [[noreturn]] void fail(const std::string& path, const std::string& what,
                           const std::string& remedy = "docs/scene_format.md has each key") const;
    void expect_array(const Json& json, const std::string& path) const;
    double number_of(const Json& json, const std::string& path) const;
    Double3 color_of(const Json& json, const std::string& path) const;
    std::string string_of(const Json& json, const std::string& path) const;
    template <class Vector>
    Vector vector_of(const Json& json, const std::string& path) const;
    MaterialId material_of(const std::string& name, const std::string& path);
    TextureId texture_of(const Json& json, const std::string& path);
    TextureId inline_texture(const Json& json, const std::string& path);
    void read_camera(const Json& json, const std::string& path, Scene& scene);
    static Material with_name_of(const Material& named, Material value);
    /// True if the key takes a thing away, which only changes may do.
    bool takes_away(const Json* json) const { return changes_ && json && json->is_null(); }
    template <class List, class Read>
    void read_changes(const ModelChanges& changes, const char* key, List& list, const Read& read);
    [[noreturn]] void unknown_name(const std::string& path, const char* what,
                                   const std::string& name,
                                   const std::vector<std::string>& names) const;

    template <class Enum>
    Enum enum_of(const Json& json, const std::string& path) const {
        const std::string name = string_of(json, path);
        if (const auto value = enum_value<Enum>(name)) return *value;
        std::vector<std::string> names;
        for (const auto& row : EnumTable<Enum>::rows)
            names.emplace_back(row.name);
        unknown_name(path, "value", name, names);
    }

    template <class Enum>
    void required_kind(const char* key, Enum& value) {
        const Json* json = find(key);
        if (!json && changes_) return;
        if (!json)
            fail(path_, std::string("the key \"") + key + "\" is missing",
                 "one of: " + enum_names<Enum>());
        value = enum_of<Enum>(*json, path_of(key));
    }

    ReadState& state_;
    const Json& json_;
    std::string path_;
    bool changes_;
    std::vector<std::string> known_;  // keys asked for so far
    std::string schema_key_;          // taken, but not offered in messages
};

}  // namespace tp
