// A validator for as much of JSON Schema (draft 2020-12) as assets/scene.schema.json uses. An
// unknown keyword is an error, so that none is silently passed over.
#pragma once

#include <nlohmann/json.hpp>

#include <regex>
#include <stdexcept>
#include <string>

namespace tp::test {

class SchemaValidator {
public:
    explicit SchemaValidator(const nlohmann::json& root) : root_(root) {}

    /// The first mistake as "place: what", or "" for a valid document.
    std::string check(const nlohmann::json& value) const { return check(root_, value, "$"); }

private:
    using Json = nlohmann::json;

    static bool has_type(const Json& value, const Json& type) {
        if (!type.is_array()) return has_type(value, type.get<std::string>());
        return std::any_of(type.begin(), type.end(),
                           [&](const Json& one) { return has_type(value, one); });
    }

    static bool has_type(const Json& value, const std::string& type) {
        if (type == "null") return value.is_null();
        if (type == "object") return value.is_object();
        if (type == "array") return value.is_array();
        if (type == "string") return value.is_string();
        if (type == "boolean") return value.is_boolean();
        if (type == "number") return value.is_number();
        if (type == "integer")
            return value.is_number() && std::floor(value.get<double>()) == value.get<double>();
        throw std::logic_error("schema: unknown type " + type);
    }

    std::string check(const Json& schema, const Json& value, const std::string& at) const {
        if (schema.is_boolean()) return schema.get<bool>() ? "" : at + ": not allowed";
        for (const auto& [keyword, rule] : schema.items())
            if (std::string error = apply(keyword, rule, schema, value, at); !error.empty())
                return error;
        return "";
    }

    std::string apply(const std::string& keyword, const Json& rule, const Json& schema,
                      const Json& value, const std::string& at) const {
        const auto fails = [&](bool wrong) { return wrong ? at + ": " + keyword : std::string(); };
        const bool number = value.is_number(), list = value.is_array(), object = value.is_object();
        if (keyword == "$ref") {
            const std::string pointer = rule.get<std::string>().substr(1);
            return check(root_.at(Json::json_pointer(pointer)), value, at);
        }
        if (keyword == "type") return fails(!has_type(value, rule));
        if (keyword == "const") return fails(value != rule);
        if (keyword == "enum")
            return fails(std::find(rule.begin(), rule.end(), value) == rule.end());
        if (keyword == "minimum") return fails(number && value < rule);
        if (keyword == "maximum") return fails(number && value > rule);
        if (keyword == "exclusiveMinimum") return fails(number && value <= rule);
        if (keyword == "exclusiveMaximum") return fails(number && value >= rule);
        if (keyword == "minItems") return fails(list && value.size() < rule);
        if (keyword == "maxItems") return fails(list && value.size() > rule);
        if (keyword == "minLength")
            return fails(value.is_string() && value.get<std::string>().size() < rule);
        if (keyword == "pattern")
            return fails(
                value.is_string() &&
                !std::regex_search(value.get<std::string>(), std::regex(rule.get<std::string>())));
        if (keyword == "items") {
            for (size_t i = 0; list && i < value.size(); ++i)
                if (std::string e = check(rule, value[i], at + "[" + std::to_string(i) + "]");
                    !e.empty())
                    return e;
            return "";
        }
        if (keyword == "required") {
            for (const auto& key : rule)
                if (object && !value.contains(key.get<std::string>()))
                    return at + ": missing " + key.get<std::string>();
            return "";
        }
        if (keyword == "properties") {
            for (const auto& [key, inner] : rule.items())
                if (object && value.contains(key))
                    if (std::string e = check(inner, value[key], at + "." + key); !e.empty())
                        return e;
            return "";
        }
        if (keyword == "additionalProperties") {
            if (!object) return "";
            for (const auto& [key, inner] : value.items())
                if (!schema.contains("properties") || !schema["properties"].contains(key))
                    if (std::string e = check(rule, inner, at + "." + key); !e.empty()) return e;
            return "";
        }
        if (keyword == "propertyNames") {
            if (!object) return "";
            for (const auto& [key, inner] : value.items())
                if (std::string e = check(rule, key, at); !e.empty()) return e;
            return "";
        }
        if (keyword == "anyOf" || keyword == "oneOf") {
            int valid = 0;
            for (const Json& branch : rule)
                valid += check(branch, value, at).empty();
            return fails(keyword == "anyOf" ? valid == 0 : valid != 1);
        }
        if (keyword == "not") return fails(check(rule, value, at).empty());
        if (keyword == "$schema" || keyword == "$defs" || keyword == "title" ||
            keyword == "description" || keyword == "default")
            return "";
        throw std::logic_error("schema: unknown keyword " + keyword);
    }

    const Json& root_;
};

}  // namespace tp::test
