#include "scene_reader.h"

#include "scene_fields.h"

#include <teapath/core/color.h>
#include <teapath/core/error.h>
#include <teapath/core/log.h>
#include <teapath/core/nearest_name.h>
#include <teapath/io/shape_types.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tp {
namespace {

// The linear colour of "#rgb" or "#rrggbb", or nothing.
bool parse_hex(const std::string& text, Double3& color) {
    if (text.size() != 4 && text.size() != 7) return false;
    if (text[0] != '#' || text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
        return false;
    for (int c = 0; c < 3; ++c) {
        const auto index = static_cast<size_t>(c);
        const std::string digits =
            text.size() == 7 ? text.substr(1 + 2 * index, 2) : std::string(2, text[1 + index]);
        color[c] = static_cast<double>(
            linear_from_srgb(static_cast<float>(std::stoi(digits, nullptr, 16)) / 255.0f));
    }
    return true;
}

template <class Names>
std::vector<std::string> keys_of(const Names& names) {
    std::vector<std::string> keys;
    for (const auto& [name, id] : names)
        keys.push_back(name);
    return keys;
}

}  // namespace

SceneReader::SceneReader(ReadState& state, const Json& json, std::string path, bool changes)
    : state_(state), json_(json), path_(std::move(path)), changes_(changes) {
    if (!json.is_object())
        fail(path_, fmt::format("expected an object, found {}", type_name(json)));
}

const Json* SceneReader::find(const char* key) {
    known_.emplace_back(key);
    const auto found = json_.find(key);
    return found == json_.end() ? nullptr : &*found;
}

void SceneReader::fail(const std::string& path, const std::string& what,
                       const std::string& remedy) const {
    throw Error(ErrorKind::Input, what, path.empty() ? state_.file : state_.file + ": " + path,
                remedy);
}

void SceneReader::finish() const {
    for (const auto& [key, value] : json_.items()) {
        const bool is_known = std::find(known_.begin(), known_.end(), key) != known_.end();
        if (!is_known && key != schema_key_) unknown_name(path_, "key", key, known_);
    }
}

void SceneReader::unknown_name(const std::string& path, const char* what, const std::string& name,
                               const std::vector<std::string>& names) const {
    const std::string nearest = nearest_name(name, names);
    std::string remedy;
    if (!nearest.empty())
        remedy = fmt::format("did you mean \"{}\"?", nearest);
    else if (names.size() <= 24)
        remedy = names.empty() ? fmt::format("there is none in this file")
                               : fmt::format("known: {}", fmt::join(names, ", "));
    fail(path, fmt::format("unknown {} \"{}\"", what, name), remedy);
}

void SceneReader::expect_array(const Json& json, const std::string& path) const {
    if (!json.is_array()) fail(path, fmt::format("expected a list, found {}", type_name(json)));
}

double SceneReader::number_of(const Json& json, const std::string& path) const {
    if (!json.is_number()) fail(path, fmt::format("expected a number, found {}", type_name(json)));
    const double value = json.get<double>();
    if (!std::isfinite(value)) fail(path, "the number is not finite", "numbers stay below 1e308");
    return value;
}

std::string SceneReader::string_of(const Json& json, const std::string& path) const {
    if (!json.is_string()) fail(path, fmt::format("expected a string, found {}", type_name(json)));
    return json.get<std::string>();
}

template <class Vector>
Vector SceneReader::vector_of(const Json& json, const std::string& path) const {
    constexpr int kLength = Vector::length();
    if (!json.is_array() || json.size() != static_cast<size_t>(kLength))
        fail(path, fmt::format(
                       "expected a list of {} numbers, found {}", kLength,
                       json.is_array() ? fmt::format("one of {}", json.size()) : type_name(json)));
    Vector v;
    for (int i = 0; i < kLength; ++i)
        v[i] = number_of(json[static_cast<size_t>(i)], fmt::format("{}[{}]", path, i));
    return v;
}

Double3 SceneReader::color_of(const Json& json, const std::string& path) const {
    if (json.is_number()) return Double3(number_of(json, path));
    Double3 color;
    if (json.is_string() && parse_hex(json.get<std::string>(), color)) return color;
    if (!json.is_array())
        fail(path,
             fmt::format("expected a colour, found {}",
                         json.is_string() ? json.dump() : type_name(json)),
             "three numbers, one number for grey, or \"#rrggbb\"");
    return vector_of<Double3>(json, path);
}

void SceneReader::operator()(const char* key, bool& value) {
    const Json* json = find(key);
    if (!json) return;
    if (!json->is_boolean())
        fail(path_of(key), fmt::format("expected true or false, found {}", type_name(*json)));
    value = json->get<bool>();
}

void SceneReader::operator()(const char* key, int& value) {
    const Json* json = find(key);
    if (!json) return;
    const double number = number_of(*json, path_of(key));
    if (number != std::floor(number) || std::abs(number) > 2147483647.0)
        fail(path_of(key), fmt::format("expected a whole number, found {}", json->dump()),
             "between -2147483647 and 2147483647");
    value = static_cast<int>(number);
}

void SceneReader::operator()(const char* key, uint64_t& value) {
    const Json* json = find(key);
    if (!json) return;
    const double number = number_of(*json, path_of(key));
    const bool is_whole = number >= 0 && number < 0x1p53 && number == std::floor(number);
    if (!json->is_number_unsigned() && !is_whole)
        fail(path_of(key), fmt::format("expected a whole number, found {}", json->dump()),
             "from 0 to 18446744073709551615");
    value = json->is_number_unsigned() ? json->get<uint64_t>() : static_cast<uint64_t>(number);
}

void SceneReader::operator()(const char* key, double& value) {
    if (const Json* json = find(key)) value = number_of(*json, path_of(key));
}

void SceneReader::operator()(const char* key, float& value) {
    double number = static_cast<double>(value);
    (*this)(key, number);
    value = static_cast<float>(number);
    if (!std::isfinite(value)) fail(path_of(key), "the number is too large");
}

void SceneReader::operator()(const char* key, std::string& value) {
    if (const Json* json = find(key)) value = string_of(*json, path_of(key));
}

void SceneReader::operator()(const char* key, Double2& value) {
    if (const Json* json = find(key)) value = vector_of<Double2>(*json, path_of(key));
}

void SceneReader::operator()(const char* key, Double3& value) {
    if (const Json* json = find(key)) value = vector_of<Double3>(*json, path_of(key));
}

void SceneReader::operator()(const char* key, std::vector<Double4>& value) {
    const Json* json = find(key);
    if (!json) return;
    expect_array(*json, path_of(key));
    value.clear();
    for (size_t i = 0; i < json->size(); ++i)
        value.push_back(vector_of<Double4>((*json)[i], fmt::format("{}[{}]", path_of(key), i)));
}

void SceneReader::operator()(const char* key, TexturedColor& value) {
    const Json* json = find(key);
    if (!json) return;
    // A texture may have a name that looks like a colour.
    const std::string name = json->is_string() ? json->get<std::string>() : std::string();
    const bool is_texture =
        json->is_object() ||
        (json->is_string() && (!name.starts_with('#') || state_.texture_names.count(name)));
    value.texture = is_texture ? texture_of(*json, path_of(key)) : TextureId{};
    if (!is_texture) value.color = color_of(*json, path_of(key));
}

void SceneReader::operator()(const char* key, TexturedNumber& value) {
    const Json* json = find(key);
    if (!json) return;
    if (json->is_object()) {
        SceneReader inner(state_, *json, path_of(key));
        if (!json->contains("texture"))
            fail(path_of(key), "the key \"texture\" is missing",
                 R"(a number, or {"value": 1, "texture": "name", "channel": "red"})");
        value.value = 1;
        inner("value", value.value);
        inner.texture("texture", value.texture);
        inner("channel", value.channel);
        inner.finish();
    } else {
        value.value = number_of(*json, path_of(key));
        value.texture = {};
    }
}

void SceneReader::operator()(const char* key, MaterialId& value) {
    const Json* json = find(key);
    if (!json) return;
    if (takes_away(json)) {
        value = {};
        return;
    }
    if (json->is_string()) {
        value = material_of(json->get<std::string>(), path_of(key));
        return;
    }
    if (!json->is_object())
        fail(path_of(key),
             fmt::format("expected a material or the name of one, found {}", type_name(*json)));
    SceneReader inner(state_, *json, path_of(key));
    Material material;
    material_fields(inner, material);
    inner.finish();
    value = {static_cast<uint32_t>(state_.scene.materials.size()) + 1};
    material.id = value;
    state_.scene.materials.edit().push_back(std::move(material));
}

MaterialId SceneReader::material_of(const std::string& name, const std::string& path) {
    const auto found = state_.material_names.find(name);
    if (found != state_.material_names.end()) return found->second;
    if (!state_.model_is_missing)
        unknown_name(path, "material", name, keys_of(state_.material_names));
    log_warning(
        "{}: {}: the material \"{}\" is not there, maybe for want of a model; a grey one "
        "takes its place",
        state_.file, path, name);
    Material material;
    material.id = {static_cast<uint32_t>(state_.scene.materials.size()) + 1};
    material.name = name;
    state_.scene.materials.edit().push_back(material);
    return state_.material_names[name] = material.id;
}

void SceneReader::required(const char* key, std::string& value, const char* remedy) {
    const Json* json = find(key);
    if (!json) fail(path_, fmt::format("the key \"{}\" is missing", key), remedy);
    value = string_of(*json, path_of(key));
}

void SceneReader::color(const char* key, Double3& value) {
    if (const Json* json = find(key)) value = color_of(*json, path_of(key));
}

void SceneReader::texture(const char* key, TextureId& value) {
    const Json* json = find(key);
    if (!json) return;
    if (takes_away(json)) {
        value = {};
        return;
    }
    if (!json->is_object() && !json->is_string())
        fail(path_of(key),
             fmt::format("expected a texture or the name of one, found {}", type_name(*json)));
    value = texture_of(*json, path_of(key));
}

void SceneReader::image(const char* key, ImageFile& value) {
    if (changes_ && !json_.contains(key)) return;
    const std::string before = value.path;
    required(key, value.path, "the path of an image, relative to the scene file");
    if (value.path != before) value.image = nullptr;
}

void SceneReader::optional_image(const char* key, ImageFile& value) {
    const std::string before = value.path;
    (*this)(key, value.path);
    if (value.path != before) value.image = nullptr;
}

void SceneReader::mesh(const char* key, MeshFile& value) {
    required(key, value.path, "the path of a mesh (.ply, .stl, .obj), relative to the scene file");
}

void SceneReader::matrix(const char* key, DoubleMat3& value) {
    const Json* json = find(key);
    if (!json) return;
    expect_array(*json, path_of(key));
    if (json->size() != 9)
        fail(path_of(key), fmt::format("expected 9 numbers, found {}", json->size()),
             "the columns of a matrix, one after the other");
    for (int i = 0; i < 9; ++i)
        value[i / 3][i % 3] =
            number_of((*json)[static_cast<size_t>(i)], fmt::format("{}[{}]", path_of(key), i));
}

void SceneReader::schema(const char* key, std::string& value) {
    schema_key_ = key;
    if (const auto found = json_.find(key); found != json_.end())
        value = string_of(*found, path_of(key));
}

void SceneReader::glow(const char* key, bool& emits, TexturedColor& value) {
    const auto found = json_.find(key);
    if (found != json_.end() && takes_away(&*found)) {
        known_.emplace_back(key);
        emits = false;
        return;
    }
    emits = found != json_.end() || (changes_ && emits);
    (*this)(key, value);
}

void SceneReader::constant(const char* key, const char* value) {
    const Json* json = find(key);
    if (!json)
        fail(path_, fmt::format("the key \"{}\" is missing", key),
             fmt::format("it must be \"{}\"", value));
    const std::string found = string_of(*json, path_of(key));
    if (found != value) unknown_name(path_of(key), "value", found, {value});
}

void SceneReader::constant(const char* key, int value) {
    const Json* json = find(key);
    if (!json)
        fail(path_,
             fmt::format("the key \"{}\" is missing, so this is not a scene of Teapath", key),
             fmt::format("add \"{}\": {}", key, value));
    if (number_of(*json, path_of(key)) != value)
        fail(path_of(key), fmt::format("version {} of the format is unknown", json->dump()),
             fmt::format("this program reads version {}", value));
}

void SceneReader::shape(const char* key, Shape& value) {
    const Json* json = find(key);
    if (!json && changes_) return;
    if (!json)
        fail(path_, "the key \"shape\" is missing",
             R"(for example "shape": {"type": "sphere", "center": [0, 1, 0], "radius": 1})");
    SceneReader inner(state_, *json, path_of(key));
    const Json* type = inner.find("type");
    if (!type) fail(path_of(key), "the key \"type\" is missing", "one of: " + shape_type_names());
    const std::string name = string_of(*type, inner.path_of("type"));
    if (!make_shape(name, value)) {
        std::vector<std::string> names(kShapeTypes.begin(), kShapeTypes.end());
        unknown_name(inner.path_of("type"), "shape", name, names);
    }
    std::visit([&](auto& s) { shape_fields(inner, s); }, value);
    inner.finish();
}

TextureId SceneReader::texture_of(const Json& json, const std::string& path) {
    if (json.is_object()) return inline_texture(json, path);
    const std::string name = json.get<std::string>();
    const auto found = state_.texture_names.find(name);
    if (found != state_.texture_names.end()) return found->second;
    if (!state_.model_is_missing)
        unknown_name(path, "texture", name, keys_of(state_.texture_names));
    log_warning("{}: {}: the texture \"{}\" is not there, maybe for want of a model", state_.file,
                path, name);
    return {};
}

}  // namespace tp
