// Values of glTF extensions, which tinygltf leaves as trees: what is missing or of another kind is
// the given default.
#pragma once

#include "tinygltf.h"

#include <teapath/core/math.h>

#include <string>
#include <vector>

namespace tp {

/// The extension of that name, or null.
inline const tinygltf::Value* find_extension(const tinygltf::ExtensionMap& extensions,
                                             const char* name) {
    const auto found = extensions.find(name);
    return found != extensions.end() && found->second.IsObject() ? &found->second : nullptr;
}

inline const tinygltf::Value* find_value(const tinygltf::Value& object, const char* key) {
    return object.Has(key) ? &object.Get(key) : nullptr;
}

inline double number_in(const tinygltf::Value& object, const char* key, double absent) {
    const tinygltf::Value* value = find_value(object, key);
    return value && value->IsNumber() ? value->GetNumberAsDouble() : absent;
}

/// A whole number, or `absent` also for those that an int cannot hold.
inline int index_in(const tinygltf::Value& object, const char* key, int absent) {
    const double value = number_in(object, key, absent);
    return value >= -1 && value < 2147483647.0 ? static_cast<int>(value) : absent;
}

template <class Vector>
Vector vector_in(const tinygltf::Value& object, const char* key, Vector absent) {
    const tinygltf::Value* list = find_value(object, key);
    if (!list || list->ArrayLen() < static_cast<size_t>(Vector::length())) return absent;
    for (int i = 0; i < Vector::length(); ++i) {
        const tinygltf::Value& number = list->Get(i);
        if (!number.IsNumber()) return absent;
        absent[i] = number.GetNumberAsDouble();
    }
    return absent;
}

template <class Vector>
Vector vector_of(const std::vector<double>& numbers, Vector absent) {
    if (numbers.size() < static_cast<size_t>(Vector::length())) return absent;
    for (int i = 0; i < Vector::length(); ++i)
        absent[i] = numbers[static_cast<size_t>(i)];
    return absent;
}

}  // namespace tp
