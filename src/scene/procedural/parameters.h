// The name and the numbers of a procedural mesh's path.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace tp {

class ProceduralParameters {
public:
    /// Splits "procedural://name?key=value&key=value". Throws Error(Input).
    explicit ProceduralParameters(std::string_view path);

    const std::string& name() const { return name_; }

    /// The number behind `key`, or the default. Throws Error(Input) beyond the range.
    double number(const char* key, double standard, double low, double high);
    int whole(const char* key, int standard, int low, int high);

    /// Throws Error(Input) if a key was given that nobody asked for.
    void finish() const;

private:
    [[noreturn]] void fail(const std::string& what, const std::string& remedy) const;

    std::string path_, name_;
    std::map<std::string, double> given_, asked_;
};

}  // namespace tp
