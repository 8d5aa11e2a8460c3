// What the checks of a scene have in common: collecting problems, and ranges of numbers.
#pragma once

#include <teapath/core/math.h>
#include <teapath/scene/validate.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace tp {

/// A place in the scene's JSON: a key or an element in an outer place. It costs nothing until its
/// text is asked for, since most places have no problem. The outer place must outlive it.
class Place {
public:
    Place(const char* key) : key_(key) {}
    Place(const std::string& key) : key_(key) {}
    Place operator/(std::string_view key) const { return {this, key, kNoIndex}; }
    Place operator[](size_t index) const { return {this, {}, index}; }

    std::string text() const {
        const std::string outer = outer_ ? outer_->text() : std::string();
        if (index_ != kNoIndex) return fmt::format("{}[{}]", outer, index_);
        return outer.empty() ? std::string(key_) : fmt::format("{}.{}", outer, key_);
    }

private:
    static constexpr size_t kNoIndex = ~size_t{0};
    Place(const Place* outer, std::string_view key, size_t index)
        : outer_(outer), key_(key), index_(index) {}

    const Place* outer_ = nullptr;
    std::string_view key_;
    size_t index_ = kNoIndex;
};

class ProblemList {
public:
    // Numbers of this size keep their squares, and lengths their inverse squares, inside float.
    static constexpr double kLargest = 1e15;
    static constexpr double kSmallest = 1e-15;

    std::vector<Problem> take() { return std::move(problems_); }

    void fatal(const Place& where, std::string what, std::string remedy) {
        problems_.push_back({true, where.text(), std::move(what), std::move(remedy)});
    }
    void warn(const Place& where, std::string what, std::string remedy = {}) {
        problems_.push_back({false, where.text(), std::move(what), std::move(remedy)});
    }

    /// True if the number is usable at all; a problem otherwise.
    bool finite(const Place& where, double value) {
        if (std::isfinite(value) && std::abs(value) <= kLargest) return true;
        fatal(where,
              std::isfinite(value) ? fmt::format("{} is too large", value)
                                   : std::string("the number is not finite"),
              "numbers stay between -1e15 and 1e15");
        return false;
    }
    template <int kLength>
    bool finite(const Place& where, const glm::vec<kLength, double>& v) {
        for (int i = 0; i < kLength; ++i)
            if (!finite(where[static_cast<size_t>(i)], v[i])) return false;
        return true;
    }

    bool in_range(const Place& where, double value, double low, double high) {
        if (value >= low && value <= high) return true;
        fatal(where, fmt::format("{} is out of range", value),
              fmt::format("from {} to {}", low, high));
        return false;
    }
    bool in_range(const Place& where, int value, int low, int high) {
        if (value >= low && value <= high) return true;
        fatal(where, fmt::format("{} is out of range", value),
              fmt::format("from {} to {}", low, high));
        return false;
    }

    /// A number that may be 0 and is not negative.
    bool not_negative(const Place& where, double value, const char* what,
                      const char* remedy = "0 or more") {
        if (!finite(where, value)) return false;
        if (value < 0) fatal(where, fmt::format("the {} is negative", what), remedy);
        return value >= 0;
    }

    /// A colour or radiance: finite, no part below 0.
    void color(const Place& where, const Double3& color) {
        if (finite(where, color) && (color.x < 0 || color.y < 0 || color.z < 0))
            fatal(where, "a colour has a negative part", "colours are 0 or more");
    }

    /// What a light gives off: its colour times its strength.
    void radiance(const Place& where, const Double3& color, double strength) {
        const double most = std::max({color.x, color.y, color.z}) * strength;
        if (most > kMaxRadiance && most <= kLargest * kLargest)
            fatal(where, fmt::format("a radiance of {:g} is too much", most),
                  fmt::format("colour times strength is {:g} at most", kMaxRadiance));
    }

private:
    std::vector<Problem> problems_;
};

/// The parts of `validate`, each in a file of its own.
void check_textures_and_materials(const Scene& scene, ProblemList& problems);
void check_objects(const Scene& scene, ProblemList& problems);

}  // namespace tp
