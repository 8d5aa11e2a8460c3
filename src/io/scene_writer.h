// The visitor of scene_fields.h that writes a struct into a JSON object.
#pragma once

#include "json_text.h"

#include <teapath/scene/enum_tables.h>
#include <teapath/scene/scene.h>

#include <map>
#include <set>
#include <string>

namespace tp {

/// Names that things are written by: their own, with a number where another has the same, or one
/// made up for what is used twice without a name.
struct WriteState {
    const Scene& scene;
    bool with_defaults;  // also writes what has its default
    std::map<CameraId, std::string> camera_names;
    std::map<TextureId, std::string> texture_names;
    std::map<MaterialId, std::string> material_names;
    std::map<TextureId, const Texture*> textures;
    std::map<MaterialId, const Material*> materials;
    std::set<ModelId> models;

    /// True if the model's entry says what the thing is.
    bool is_of_model(const ModelPart& part) const { return models.count(part.model) > 0; }

    explicit WriteState(const Scene& scene, bool with_defaults = false);
};

class SceneWriter {
public:
    explicit SceneWriter(const WriteState& state) : state_(state) {}

    Json take() { return std::move(json_); }

    void operator()(const char* key, bool value) { json_[key] = value; }
    void operator()(const char* key, int value) { json_[key] = value; }
    void operator()(const char* key, uint64_t value) { json_[key] = value; }
    void operator()(const char* key, double value) { json_[key] = number(value); }
    void operator()(const char* key, float value);
    void operator()(const char* key, const std::string& value) { json_[key] = value; }
    void operator()(const char* key, const Double2& value) {
        json_[key] = Json{number(value.x), number(value.y)};
    }
    void operator()(const char* key, const Double3& value) { json_[key] = vector(value); }
    void operator()(const char* key, const std::vector<Double4>& value);
    void operator()(const char* key, const TexturedColor& value);
    void operator()(const char* key, const TexturedNumber& value);
    void operator()(const char* key, MaterialId value);

    template <class Enum>
    requires std::is_enum_v<Enum>
    void operator()(const char* key, Enum value) { json_[key] = std::string(enum_name(value)); }

    void color(const char* key, const Double3& value) { json_[key] = vector(value); }
    void texture(const char* key, TextureId value);
    void image(const char* key, const ImageFile& value) { json_[key] = value.path; }
    void optional_image(const char* key, const ImageFile& value) {
        if (!value.path.empty()) json_[key] = value.path;
    }
    void mesh(const char* key, const MeshFile& value) { json_[key] = value.path; }
    void matrix(const char* key, const DoubleMat3& value);
    void schema(const char* key, const std::string& value) {
        if (!value.empty()) json_[key] = value;
    }
    template <class Enum>
    void kind(const char* key, Enum value) {
        (*this)(key, value);
    }
    void start_from(Material&, const Material&) {}
    void glow(const char* key, bool emits, const TexturedColor& value) {
        if (emits) (*this)(key, value);
    }
    void constant(const char* key, const char* value) { json_[key] = value; }
    void constant(const char* key, int value) { json_[key] = value; }
    void shape(const char* key, Shape& value);
    void cameras(const Scene& scene);
    void models(const char* key, const Scene& scene);
    void changes(const char*) {}  // models() adds them
    void model_changes() {}
    void required(const char* key, const std::string& value, const char*) { json_[key] = value; }
    void named(const char* key, std::vector<Texture>& textures);
    void named(const char* key, std::vector<Material>& materials);

    /// Writes what differs from a default T, nothing if nothing does.
    template <class T, class Fields>
    void object(const char* key, T& value, Fields&& fields) {
        Json inner = difference(value, fields);
        if (!inner.empty()) json_[key] = std::move(inner);
    }

    template <class T, class Fields>
    void list(const char* key, std::vector<T>& values, Fields&& fields) {
        Json items = Json::array();
        for (T& value : values) {
            if constexpr (requires { value.part; })
                if (state_.is_of_model(value.part)) continue;
            items.push_back(difference(value, fields));
        }
        if (!items.empty()) json_[key] = std::move(items);
    }

private:
    const std::string& name_of(MaterialId id) const { return state_.material_names.at(id); }
    const std::string& name_of(TextureId id) const { return state_.texture_names.at(id); }
    template <class Thing>
    Json changes_of(const Model& model, const std::vector<Thing>& things,
                    std::vector<Thing> before) const;

    template <class T, class Fields>
    Json difference(T& value, Fields&& fields) const {
        T standard = default_like(value);
        SceneWriter mine(state_), theirs(state_);
        fields(mine, value);
        if (state_.with_defaults) return mine.take();
        fields(theirs, standard);
        return without_defaults(mine.take(), theirs.take());
    }

    template <class T>
    static T default_like(const T&) {
        return T{};
    }
    static Background default_like(const Background& b);
    static Texture default_like(const Texture& t);
    static Material default_like(const Material& m);

    /// A whole number is written without a point; nothing is lost.
    static Json number(double value);
    static Json vector(const Double3& v) { return Json{number(v.x), number(v.y), number(v.z)}; }
    static Json without_defaults(Json json, const Json& standard);

    const WriteState& state_;
    Json json_ = Json::object();
};

}  // namespace tp
