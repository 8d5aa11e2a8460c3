// The JSON Schema against the reader: the same keys, types, defaults and names, both ways; the
// schema accepts every shipped and every saved scene, and refuses what the reader refuses.
#include "../src/io/scene_fields.h"
#include "support/json_schema.h"
#include "support/shipped_scenes.h"

#include <teapath/core/error.h>
#include <teapath/io/scene_file.h>
#include <teapath/io/shape_types.h>

#include <doctest/doctest.h>

#include <set>

using namespace tp;
using nlohmann::json;

namespace {

const json& schema() {
    static const json root =
        json::parse(test::text_of(std::string(TEAPATH_SOURCE_DIR) + "/assets/scene.schema.json"));
    return root;
}

const json& definition(const std::string& name) {
    return schema().at("$defs").at(name);
}

// A visitor of scene_fields.h that compares each key, with its default, to a definition's
// properties.
class SchemaCheck {
public:
    explicit SchemaCheck(const json& definition) : definition_(definition) {
        CHECK(definition.at("additionalProperties") == false);
    }
    ~SchemaCheck() {
        for (const auto& item : properties().items()) {
            const std::string& key = item.key();
            CAPTURE(key);
            CHECK_MESSAGE(keys_.count(key) == 1, "the schema has a key that the reader has not");
        }
    }
    SchemaCheck(const SchemaCheck&) = delete;
    SchemaCheck& operator=(const SchemaCheck&) = delete;

    void operator()(const char* key, bool value) { typed(key, "boolean", value); }
    void operator()(const char* key, int value) { typed(key, "integer", value); }
    void operator()(const char* key, uint64_t value) { typed(key, "integer", value); }
    void operator()(const char* key, double value) { typed(key, "number", value); }
    void operator()(const char* key, float value) { typed(key, "number", value); }
    void operator()(const char* key, const std::string& value) { typed(key, "string", value); }
    void operator()(const char* key, const Double2& v) { refers(key, "vec2", {v.x, v.y}); }
    void operator()(const char* key, const Double3& v) { refers(key, "vec3", {v.x, v.y, v.z}); }
    void operator()(const char* key, const std::vector<Double4>&) {
        typed(key, "array", json::array());
    }
    void operator()(const char* key, const TexturedColor& v) {
        refers(key, "textured", {v.color.x, v.color.y, v.color.z});
    }
    void operator()(const char* key, const TexturedNumber& v) {
        const bool is_length = std::string(key).find("thickness") != std::string::npos;
        refers(key, is_length ? "textured_thickness" : "textured_number", v.value);
    }
    void operator()(const char* key, MaterialId) { property(key); }
    template <class Enum>
    requires std::is_enum_v<Enum>
    void operator()(const char* key, Enum value) {
        const json p = property(key);
        json names = json::array();
        for (const auto& row : EnumTable<Enum>::rows)
            names.push_back(std::string(row.name));
        CHECK(p.at("enum") == names);
        CHECK(p.at("default") == std::string(enum_name(value)));
    }

    void color(const char* key, const Double3& v) { refers(key, "color", {v.x, v.y, v.z}); }
    void texture(const char* key, TextureId) {
        CHECK(property(key).at("$ref") == "#/$defs/texture_slot");
    }
    void image(const char* key, const ImageFile&) {
        CHECK(property(key).at("type") == "string");
        check_required(key);
    }
    void optional_image(const char* key, const ImageFile&) {
        CHECK(property(key).at("type") == "string");
    }
    void mesh(const char* key, const MeshFile&) {
        CHECK(property(key).at("type") == "string");
        check_required(key);
    }
    void matrix(const char* key, const DoubleMat3&) {
        CHECK(property(key).at("minItems") == 9);
        CHECK(property(key).at("maxItems") == 9);
    }
    void schema(const char* key, const std::string&) { property(key); }
    void constant(const char* key, const json& value) {
        CHECK(property(key).at("const") == value);
        check_required(key);
    }
    template <class Enum>
    void kind(const char* key, Enum value) {
        constant(key, std::string(enum_name(value)));
    }
    void start_from(Material& value, const Material& standard) { value = standard; }
    void glow(const char* key, bool, const TexturedColor&) {
        CHECK(property(key).at("$ref") == "#/$defs/textured");
        CHECK_FALSE(property(key).contains("default"));
    }
    void shape(const char* key, const Shape&) {
        CHECK(property(key).at("$ref") == "#/$defs/shape");
        check_required(key);
    }
    void required(const char* key, const std::string&, const char*) {
        CHECK(property(key).at("type") == "string");
        check_required(key);
    }
    void models(const char* key, const Scene&) {
        CHECK(property(key).at("items").at("$ref") == "#/$defs/model");
    }
    void changes(const char* key) { CHECK(property(key).at("type") == "object"); }
    void model_changes() {}
    void cameras(const Scene&) {
        for (const char* key : {"camera", "cameras", "active_camera"})
            property(key);
    }
    template <class T>
    void named(const char* key, const std::vector<T>&) {
        CHECK(property(key).at("type") == "object");
    }
    template <class T, class Fields>
    void object(const char* key, T&, Fields&&) {
        CHECK(property(key).at("$ref") == "#/$defs/" + std::string(key));
    }
    template <class T, class Fields>
    void list(const char* key, std::vector<T>&, Fields&&) {
        CHECK(property(key).at("type") == "array");
    }

private:
    const json& properties() const { return definition_.at("properties"); }

    json property(const char* key) {
        keys_.insert(key);
        CAPTURE(key);
        CHECK_MESSAGE(properties().contains(key), "the schema lacks a key of the reader");
        return properties().value(key, json{{"type", ""}, {"default", nullptr}, {"$ref", ""}});
    }
    void typed(const char* key, const char* type, const json& standard) {
        const json p = property(key);
        CAPTURE(key);
        CHECK(p.at("type") == type);
        CHECK(p.at("default") == standard);
    }
    void refers(const char* key, const std::string& to, const json& standard) {
        const json p = property(key);
        CAPTURE(key);
        CHECK(p.at("$ref") == "#/$defs/" + to);
        CHECK(p.at("default") == standard);
    }
    void check_required(const char* key) {
        const json required = definition_.value("required", json::array());
        CHECK(std::find(required.begin(), required.end(), key) != required.end());
    }

    const json& definition_;
    std::set<std::string> keys_;
};

// Each `name` in `table` must be a branch of the union `of`, and there must be no other.
template <class Names>
void check_branches(const char* of, const Names& names, const std::string& suffix) {
    json branches = json::array();
    for (const auto& name : names)
        branches.push_back({{"$ref", "#/$defs/" + std::string(name) + suffix}});
    CHECK(definition(of).at("oneOf") == branches);
}

template <class Enum>
std::vector<std::string> names_of() {
    std::vector<std::string> names;
    for (const auto& row : EnumTable<Enum>::rows)
        names.emplace_back(row.name);
    return names;
}

std::string mistake_in(const std::string& text) {
    return test::SchemaValidator(schema()).check(json::parse(text));
}

}  // namespace

TEST_CASE("schema: settings, cameras, objects, generators have the reader's keys and defaults") {
    Scene scene;
    Camera camera;
    Object object;
    Generator generator;
    Model model;
    SchemaCheck top(schema()), cameras(definition("camera")), render(definition("render")),
        display(definition("display")), objects(definition("object")),
        transform(definition("transform")), generators(definition("generator")),
        models(definition("model"));
    scene_fields(top, scene);
    camera_fields(cameras, camera);
    render_fields(render, scene.render);
    display_fields(display, scene.display);
    object_fields(objects, object);
    transform_fields(transform, object.transform);
    generator_fields(generators, generator);
    model_fields(models, model);
}

TEST_CASE("schema: every kind of background, texture, material and shape has the reader's keys") {
    for (const auto& row : EnumTable<BackgroundKind>::rows) {
        Background background;
        background.kind = row.value;
        SchemaCheck check(definition(std::string(row.name) + "_background"));
        background_fields(check, background);
    }
    for (const auto& row : EnumTable<TextureKind>::rows) {
        Texture texture;
        texture.kind = row.value;
        SchemaCheck check(definition(std::string(row.name) + "_texture"));
        texture_fields(check, texture);
    }
    for (const auto& row : EnumTable<MaterialKind>::rows) {
        Material material;
        material.kind = row.value;
        SchemaCheck check(definition(std::string(row.name)));
        material_fields(check, material);
    }
    for (const char* type : kShapeTypes) {
        Shape shape;
        REQUIRE(make_shape(type, shape));
        SchemaCheck check(definition(type));
        check.constant("type", type);
        std::visit([&](auto& s) { shape_fields(check, s); }, shape);
    }
    check_branches("background", names_of<BackgroundKind>(), "_background");
    check_branches("texture", names_of<TextureKind>(), "_texture");
    check_branches("material", names_of<MaterialKind>(), "");
    check_branches("shape", kShapeTypes, "");
}

TEST_CASE("schema: accepts every shipped scene, also as it is saved, and what has each default") {
    const test::SchemaValidator validator(schema());
    for (const auto& file : test::shipped_scenes()) {
        CAPTURE(file.string());
        CHECK(validator.check(json::parse(test::text_of(file))) == "");
        CHECK(validator.check(json::parse(scene_text(load_scene(file)))) == "");
    }
}

TEST_CASE("schema: refuses what the reader refuses") {
    const auto refused = [](const std::string& text) {
        CAPTURE(text);
        CHECK(mistake_in(text) != "");
        CHECK_THROWS_AS(parse_scene(text, ".", "test.json"), Error);
    };
    const auto accepted = [](const std::string& text) {
        CAPTURE(text);
        CHECK(mistake_in(text) == "");
        CHECK_NOTHROW(parse_scene(text, ".", "test.json"));
    };
    const auto object = [](const std::string& fields) {
        return R"({"teapath": 1, "objects": [{)" + fields + "}]}";
    };
    refused("[]");
    refused("{}");
    refused(R"({"teapath": 2})");
    refused(R"({"teapath": 1, "rendr": {}})");
    refused(R"({"teapath": 1, "render": {"width": 0}})");
    refused(R"({"teapath": 1, "render": {"width": 1.5}})");
    refused(R"({"teapath": 1, "render": {"seed": -1}})");
    refused(R"({"teapath": 1, "render": {"sampler": "random"}})");
    refused(R"({"teapath": 1, "camera": {"vertical_fov": 180}})");
    refused(R"({"teapath": 1, "camera": {}, "cameras": []})");
    refused(R"({"teapath": 1, "background": {}})");
    refused(R"({"teapath": 1, "background": {"type": "image"}})");
    refused(R"({"teapath": 1, "background": {"type": "constant", "color": "#12345"}})");
    refused(R"({"teapath": 1, "materials": {"": {"type": "metal"}}})");
    refused(R"({"teapath": 1, "materials": {"a": {"type": "lambertian", "fuzz": 0.5}}})");
    refused(R"({"teapath": 1, "materials": {"a": {"type": "metal", "color": [1, 1]}}})");
    refused(R"({"teapath": 1, "materials": {"a": {"type": "metal", "color": [-1, 1, 1]}}})");
    refused(object(R"("name": "no shape")"));
    refused(object(R"("shape": {"type": "disk", "radius": -1})"));
    refused(object(R"("shape": {"type": "sphere", "low": [0, 0]})"));
    accepted(R"({"teapath": 1})");
    accepted(R"({"teapath": 1, "render": {"width": 8.0, "seed": 18446744073709551615}})");
    accepted(R"({"teapath": 1, "background": {"type": "constant", "color": "#fff"}})");
    accepted(object(R"("shape": {"type": "sphere"}, "material": {"type": "metal", "color": 0.5})"));
    accepted(R"({"teapath": 1, "textures": {"map": {"type": "image", "file": "a.png"}},
                 "materials": {"a": {"type": "principled", "metallic": 1, "normal": "map",
                               "roughness": {"texture": "map", "channel": "green"}}}})");
    refused(R"({"teapath": 1, "materials": {"a": {"type": "principled", "metallic": 2}}})");
    refused(R"({"teapath": 1, "materials": {"a": {"type": "principled", "metallic": {}}}})");
}
