// Checks of a whole scene before it is rendered or saved.
#pragma once

#include <teapath/scene/scene.h>

#include <string>
#include <vector>

namespace tp {

struct Problem {
    bool fatal = true;   // false: worth a warning, the scene renders
    std::string where;   // path in the scene's JSON, e.g. "objects[3].shape.radius"
    std::string what;    // what is wrong
    std::string remedy;  // how to mend it
};

/// Every problem of the scene: numbers that are not finite or out of range, dangling ids, texture
/// cycles, degenerate shapes and cameras, sizes that cannot be rendered. Empty: all is well.
std::vector<Problem> validate(const Scene& scene);

}  // namespace tp
