#include <teapath/editor/scene_edits.h>
#include <teapath/editor/scene_tree.h>

#include <algorithm>
#include <cctype>
#include <unordered_set>

namespace tp {
namespace {

char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

}  // namespace

bool contains_text(const std::string& name, const std::string& lower_search) {
    if (lower_search.empty()) return true;
    return std::search(name.begin(), name.end(), lower_search.begin(), lower_search.end(),
                       [](char a, char b) { return lower(a) == b; }) != name.end();
}

bool gives_light(const Material& material) {
    return (material.emits || material.kind == MaterialKind::DiffuseLight) && material.strength > 0;
}

void SceneTree::add(TreeSection section, SceneItem item, size_t position, const std::string& name) {
    const auto s = static_cast<size_t>(section);
    ++totals_[s];
    if (!contains_text(name, lower_search_)) return;
    rows_[s].push_back(item);
    positions_[s].push_back(static_cast<uint32_t>(position));
}

void SceneTree::update(const std::shared_ptr<const Scene>& scene, const std::string& search) {
    if (scene == scene_ && search == search_) return;
    scene_ = scene;
    search_ = search;
    lower_search_ = search;
    std::transform(search.begin(), search.end(), lower_search_.begin(), lower);
    ++builds_;
    for (size_t s = 0; s < kTreeSections; ++s) {
        rows_[s].clear();
        positions_[s].clear();
        totals_[s] = 0;
    }
    std::unordered_set<uint32_t> lights;
    for (const Material& m : scene->materials)
        if (gives_light(m)) lights.insert(m.id.value);
    // A name is only made where there is something to look for.
    const std::string none;
    const bool searches = !search.empty();
    for (size_t i = 0; i < scene->objects.size(); ++i) {
        const Object& o = scene->objects[i];
        const bool is_light = !lights.empty() && lights.count(o.material.value) > 0;
        add(is_light ? TreeSection::Lights : TreeSection::Objects, item_of(o.id), i,
            searches ? display_name(o) : none);
    }
    const auto add_all = [&](TreeSection section, const auto& things) {
        for (size_t i = 0; i < things.size(); ++i)
            add(section, item_of(things[i].id), i,
                searches ? item_name(*scene, item_of(things[i].id)) : none);
    };
    add_all(TreeSection::Models, scene->models);
    add_all(TreeSection::Objects, scene->generators);
    add_all(TreeSection::Cameras, scene->cameras);
    add_all(TreeSection::Materials, scene->materials);
    add_all(TreeSection::Textures, scene->textures);
    add(TreeSection::Background, background_item(), 0, "Background");
}

}  // namespace tp
