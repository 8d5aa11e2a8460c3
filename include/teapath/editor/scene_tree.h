// What the tree of a scene shows, in the order of its rows: made once for a snapshot and a search,
// so that a frame costs only the rows in sight.
#pragma once

#include <teapath/editor/scene_item.h>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace tp {

enum class TreeSection : uint8_t {
    Models,
    Objects,
    Lights,
    Cameras,
    Materials,
    Textures,
    Background
};
constexpr size_t kTreeSections = 7;

class SceneTree {
public:
    /// Makes the rows anew where the snapshot or the search is another than before.
    void update(const std::shared_ptr<const Scene>& scene, const std::string& search);

    /// The rows of a section. Lights are the objects whose material emits; objects are the others,
    /// after them the generators.
    const std::vector<SceneItem>& rows(TreeSection section) const {
        return rows_[static_cast<size_t>(section)];
    }
    /// The position in its vector of the scene of each row.
    const std::vector<uint32_t>& positions(TreeSection section) const {
        return positions_[static_cast<size_t>(section)];
    }
    /// How many things the section has without the search.
    size_t total(TreeSection section) const { return totals_[static_cast<size_t>(section)]; }

    /// How often the rows were made; for tests.
    int builds() const { return builds_; }

private:
    void add(TreeSection section, SceneItem item, size_t position, const std::string& name);

    std::shared_ptr<const Scene> scene_;
    std::string search_;
    std::string lower_search_;
    std::array<std::vector<SceneItem>, kTreeSections> rows_;
    std::array<std::vector<uint32_t>, kTreeSections> positions_;
    std::array<size_t, kTreeSections> totals_{};
    int builds_ = 0;
};

/// True if `name` contains the lower-case `search`, whatever the case of its letters.
bool contains_text(const std::string& name, const std::string& lower_search);

/// True if objects of this material give light.
bool gives_light(const Material& material);

}  // namespace tp
