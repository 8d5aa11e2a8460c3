// What the checks of a scene have in common: collecting problems, and ranges of numbers.
#pragma once

#include <teapath/core/math.h>
#include <teapath/scene/validate.h>

#include <fmt/format.h>

#include <cmath>

namespace tp {

class ProblemList {
public:
    // Numbers of this size keep their squares, and lengths their inverse squares, inside float.
    static constexpr double kLargest = 1e15;
    static constexpr double kSmallest = 1e-15;

    std::vector<Problem> take() { return std::move(problems_); }

    void fatal(std::string where, std::string what, std::string remedy) {
        problems_.push_back({true, std::move(where), std::move(what), std::move(remedy)});
    }
    void warn(std::string where, std::string what, std::string remedy = {}) {
        problems_.push_back({false, std::move(where), std::move(what), std::move(remedy)});
    }

    /// True if the number is usable at all; a problem otherwise.
    bool finite(const std::string& where, double value) {
        if (std::isfinite(value) && std::abs(value) <= kLargest) return true;
        fatal(where,
              std::isfinite(value) ? fmt::format("{} is too large", value)
                                   : std::string("the number is not finite"),
              "numbers stay between -1e15 and 1e15");
        return false;
    }
    template <int kLength>
    bool finite(const std::string& where, const glm::vec<kLength, double>& v) {
        for (int i = 0; i < kLength; ++i)
            if (!finite(fmt::format("{}[{}]", where, i), v[i])) return false;
        return true;
    }

    bool in_range(const std::string& where, double value, double low, double high) {
        if (value >= low && value <= high) return true;
        fatal(where, fmt::format("{} is out of range", value),
              fmt::format("from {} to {}", low, high));
        return false;
    }
    bool in_range(const std::string& where, int value, int low, int high) {
        if (value >= low && value <= high) return true;
        fatal(where, fmt::format("{} is out of range", value),
              fmt::format("from {} to {}", low, high));
        return false;
    }

    /// A number that may be 0 and is not negative.
    bool not_negative(const std::string& where, double value, const char* what,
                      const char* remedy = "0 or more") {
        if (!finite(where, value)) return false;
        if (value < 0) fatal(where, fmt::format("the {} is negative", what), remedy);
        return value >= 0;
    }

    /// A colour or radiance: finite, no part below 0.
    void color(const std::string& where, const Double3& color) {
        if (finite(where, color) && (color.x < 0 || color.y < 0 || color.z < 0))
            fatal(where, "a colour has a negative part", "colours are 0 or more");
    }

private:
    std::vector<Problem> problems_;
};

/// The parts of `validate`, each in a file of its own.
void check_textures_and_materials(const Scene& scene, ProblemList& problems);
void check_objects(const Scene& scene, ProblemList& problems);

}  // namespace tp
