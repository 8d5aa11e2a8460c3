// What the edits of a scene share: things of any kind by their id, free ids and free names.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tp {

template <class T, class Id>
T* find_in(std::vector<T>& things, Id id) {
    const auto found =
        std::find_if(things.begin(), things.end(), [id](const T& t) { return t.id == id; });
    return id && found != things.end() ? &*found : nullptr;
}

template <class List>
auto next_id(const List& things) {
    decltype(List::value_type::id) id{0};
    for (const auto& t : things)
        id.value = std::max(id.value, t.id.value);
    ++id.value;
    return id;
}

/// The wish, or the wish with the first number that makes it one of its own; `except` may have it.
template <class List>
std::string free_name(const List& things, const std::string& wish,
                      const typename List::value_type* except = nullptr) {
    const auto taken = [&](const std::string& name) {
        return std::any_of(things.begin(), things.end(),
                           [&](const auto& t) { return &t != except && t.name == name; });
    };
    if (!taken(wish)) return wish;
    for (int n = 2;; ++n)
        if (std::string name = fmt::format("{} {}", wish, n); !taken(name)) return name;
}

}  // namespace tp
