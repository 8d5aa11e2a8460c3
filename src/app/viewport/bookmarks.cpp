#include "bookmarks.h"

#include <algorithm>
#include <string>

namespace tp {
namespace {

std::string bookmark_name(int number) {
    return "bookmark " + std::to_string(number);
}

// The view of one camera with the identity of another.
Camera viewed_as(Camera view, const Camera& identity) {
    view.id = identity.id;
    view.name = identity.name;
    return view;
}

Camera* find_by_name(Scene& scene, const std::string& name) {
    const auto found = std::find_if(scene.cameras.begin(), scene.cameras.end(),
                                    [&](const Camera& c) { return c.name == name; });
    return found == scene.cameras.end() ? nullptr : &*found;
}

}  // namespace

const Camera* find_bookmark(const Scene& scene, int number) {
    const std::string name = bookmark_name(number);
    for (const Camera& c : scene.cameras)
        if (c.name == name) return &c;
    return nullptr;
}

void set_bookmark(Scene& scene, int number) {
    const Camera view = active_camera(scene);
    const std::string name = bookmark_name(number);
    if (Camera* existing = find_by_name(scene, name)) {
        *existing = viewed_as(view, *existing);
        return;
    }
    // The first camera is looked through where none is named active; that stays so.
    if (scene.cameras.empty()) scene.cameras.push_back(view);
    Camera bookmark = view;
    bookmark.name = name;
    uint32_t highest = 0;
    for (const Camera& c : scene.cameras)
        highest = std::max(highest, c.id.value);
    bookmark.id = {highest + 1};
    scene.cameras.push_back(bookmark);
}

void go_to_bookmark(Scene& scene, int number) {
    const Camera* bookmark = find_bookmark(scene, number);
    if (!bookmark) return;
    const Camera view = *bookmark;
    const CameraId active = active_camera(scene).id;
    for (Camera& c : scene.cameras)
        if (c.id == active) c = viewed_as(view, c);
}

}  // namespace tp
