#include "parameters.h"

#include <teapath/core/error.h>
#include <teapath/core/nearest_name.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <vector>

namespace tp {
namespace {

constexpr std::string_view kScheme = "procedural://";

}  // namespace

ProceduralParameters::ProceduralParameters(std::string_view path) : path_(path) {
    path.remove_prefix(std::min(path.size(), kScheme.size()));
    const size_t question = std::min(path.find('?'), path.size());
    name_ = path.substr(0, question);
    path.remove_prefix(std::min(path.size(), question + 1));
    while (!path.empty()) {
        const size_t end = std::min(path.find('&'), path.size());
        const std::string_view pair = path.substr(0, end);
        path.remove_prefix(std::min(path.size(), end + 1));
        const size_t equals = pair.find('=');
        const std::string key(pair.substr(0, equals));
        double value = 0;
        const std::string_view text =
            equals == std::string_view::npos ? std::string_view() : pair.substr(equals + 1);
        const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = error == std::errc() && rest == text.data() + text.size();
        if (key.empty() || !whole || !std::isfinite(value))
            fail(fmt::format("\"{}\" is no parameter", pair), "key=number, joined by &");
        given_[key] = value;
    }
}

void ProceduralParameters::fail(const std::string& what, const std::string& remedy) const {
    throw Error(ErrorKind::Input, what, path_, remedy);
}

double ProceduralParameters::number(const char* key, double standard, double low, double high) {
    const auto found = given_.find(key);
    const double value = found == given_.end() ? standard : found->second;
    asked_[key] = value;
    if (!(value >= low && value <= high))
        fail(fmt::format("{} = {} is out of range", key, value),
             fmt::format("from {} to {}", low, high));
    return value;
}

int ProceduralParameters::whole(const char* key, int standard, int low, int high) {
    const double value = number(key, standard, low, high);
    if (value != std::floor(value)) fail(fmt::format("{} = {} is no whole number", key, value), "");
    return static_cast<int>(value);
}

void ProceduralParameters::finish() const {
    for (const auto& [key, value] : given_) {
        if (asked_.count(key)) continue;
        std::vector<std::string> known;
        for (const auto& [name, number] : asked_)
            known.push_back(name);
        const std::string near = nearest_name(key, known);
        fail(fmt::format("unknown parameter \"{}\"", key),
             near.empty() ? std::string() : fmt::format("did you mean \"{}\"?", near));
    }
}

}  // namespace tp
