// A GL program from two files of shaders/; RAII.
#pragma once

#include <string_view>

namespace tp {

class GlProgram {
public:
    /// Files by their names in shaders/. Throws Error(Device) with the driver's message where they
    /// do not compile.
    GlProgram(std::string_view vertex, std::string_view fragment);
    ~GlProgram();
    GlProgram(const GlProgram&) = delete;
    GlProgram& operator=(const GlProgram&) = delete;

    unsigned id() const { return id_; }

private:
    unsigned id_ = 0;
};

}  // namespace tp
