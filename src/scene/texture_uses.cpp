#include <teapath/scene/scene.h>
#include <teapath/scene/texture_uses.h>

#include <set>
#include <vector>

namespace tp {

bool holds(const Scene& scene, TextureId outer, TextureId inner) {
    std::set<TextureId> seen;
    std::vector<TextureId> open{outer};
    while (!open.empty()) {
        const TextureId id = open.back();
        open.pop_back();
        const Texture* texture = find(scene, id);
        if (!texture || !seen.insert(id).second) continue;
        bool found = false;
        for_each_slot(*texture, [&](const char*, const TexturedColor& slot) {
            found |= slot.texture == inner;
            if (slot.texture) open.push_back(slot.texture);
        });
        if (found) return true;
    }
    return false;
}

}  // namespace tp
