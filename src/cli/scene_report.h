// What a scene consists of, counted: for `teapath info`.
#pragma once

#include <teapath/scene/scene.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tp {

/// How many of each kind, in the order of the kinds; kinds that do not occur are left out.
using KindCounts = std::vector<std::pair<std::string, int64_t>>;

struct ImageReport {
    std::string path;  // as the scene file says it
    bool missing = false;
    int width = 0;
    int height = 0;
    int channels = 0;
    int bits = 0;  // of a channel; 32 = float
    size_t bytes = 0;
};

struct SceneReport {
    KindCounts objects;    // generators expanded
    KindCounts materials;  // as rendered, so with those of generators
    KindCounts textures;
    std::vector<ImageReport> images;  // each file once
    int64_t generators = 0;
    int64_t generated_objects = 0;
    int64_t hidden_objects = 0;

    // What the renderer makes of it
    int64_t lights = 0;
    int64_t tree_nodes = 0;
    int tree_depth = 0;
    double tree_cost = 0;  // expected steps of a random ray
    double build_seconds = 0;
    size_t scene_bytes = 0;
};

/// Expands the generators and builds the tree, as a render does.
SceneReport report_scene(const Scene& scene);

int64_t total(const KindCounts& counts);

}  // namespace tp
