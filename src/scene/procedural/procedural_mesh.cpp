#include "makers.h"

#include <teapath/core/error.h>
#include <teapath/core/nearest_name.h>
#include <teapath/scene/procedural_mesh.h>

#include <fmt/format.h>

#include <string>

namespace tp {
namespace {

struct Maker {
    ProceduralKind kind;
    Mesh (*make)(ProceduralParameters&);
};

const std::vector<Maker>& makers() {
    static const std::vector<Maker> all = {
        {{"teapot", "Teapot", "detail=24"}, make_teapot},
        {{"bottle", "Bottle", "detail=48"}, make_bottle},
        {{"wine_glass", "Wine glass", "detail=48&filled=0"}, make_wine_glass},
        {{"bowl", "Bowl", "detail=48"}, make_bowl},
        {{"knot", "Knot", "p=2&q=3&tube=0.25&detail=256"}, make_knot},
        {{"torus", "Torus", "tube=0.25&detail=96"}, make_torus},
        {{"rounded_box", "Rounded box", "x=1&y=1&z=1&radius=0.1&detail=8"}, make_rounded_box},
        {{"gem", "Gem", ""}, make_gem},
        {{"terrain", "Terrain", "seed=1&height=0.25&scale=4&detail=256"}, make_terrain},
        {{"tree", "Tree", "seed=1&levels=6"}, make_tree},
        {{"leaves", "Leaves of the tree", "seed=1&levels=6&size=0.06"}, make_leaves},
        {{"cloth", "Cloth", "detail=96&seed=1"}, make_cloth}};
    return all;
}

}  // namespace

bool is_procedural(std::string_view path) {
    return path.starts_with("procedural://");
}

const std::vector<ProceduralKind>& procedural_kinds() {
    static const std::vector<ProceduralKind> kinds = [] {
        std::vector<ProceduralKind> list;
        for (const Maker& maker : makers())
            list.push_back(maker.kind);
        return list;
    }();
    return kinds;
}

Mesh procedural_mesh(std::string_view path) {
    ProceduralParameters parameters(path);
    std::vector<std::string> names;
    for (const Maker& maker : makers()) {
        names.emplace_back(maker.kind.name);
        if (parameters.name() != maker.kind.name) continue;
        Mesh mesh = maker.make(parameters);
        parameters.finish();
        return mesh;
    }
    const std::string near = nearest_name(parameters.name(), names);
    throw Error(ErrorKind::Input,
                fmt::format("there is no procedural mesh \"{}\"", parameters.name()),
                std::string(path),
                near.empty() ? "docs/scene_format.md lists them"
                             : fmt::format("did you mean \"{}\"?", near));
}

}  // namespace tp
