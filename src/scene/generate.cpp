#include <teapath/scene/scene.h>
namespace tp {
Scene expand_generators(const Scene& s) {
    Scene t = s;
    t.generators.clear();
    return t;
}
}  // namespace tp
