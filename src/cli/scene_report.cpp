#include "scene_report.h"

#include <teapath/device/scene_arrays.h>
#include <teapath/io/shape_types.h>
#include <teapath/scene/enum_tables.h>

#include <algorithm>
#include <array>
#include <set>

namespace tp {
namespace {

KindCounts count_shapes(const std::vector<Object>& objects) {
    std::array<int64_t, kShapeTypes.size()> counts{};
    for (const Object& object : objects)
        ++counts[object.shape.index()];
    KindCounts found;
    for (size_t i = 0; i < counts.size(); ++i)
        if (counts[i] > 0) found.emplace_back(kShapeTypes[i], counts[i]);
    return found;
}

template <class Kind, class List>
KindCounts count_kinds(const List& things) {
    KindCounts found;
    for (const auto& row : EnumTable<Kind>::rows) {
        const auto count = std::count_if(things.begin(), things.end(), [&](const auto& thing) {
            return thing.kind == row.value;
        });
        if (count > 0) found.emplace_back(row.name, count);
    }
    return found;
}

int bits_of(PixelFormat format) {
    switch (format) {
        case PixelFormat::U8: return 8;
        case PixelFormat::U16: return 16;
        case PixelFormat::F32: return 32;
    }
    return 0;
}

ImageReport report_image(const ImageFile& file) {
    ImageReport report;
    report.path = file.path;
    report.missing = !file.image;
    if (report.missing) return report;
    report.width = file.image->width;
    report.height = file.image->height;
    report.channels = file.image->channels;
    report.bits = bits_of(file.image->format);
    report.bytes = file.image->bytes.size();
    return report;
}

std::vector<ImageReport> report_images(const Scene& scene) {
    std::vector<ImageReport> reports;
    std::set<std::string> seen;
    const auto add = [&](const ImageFile& file) {
        if (seen.insert(file.path).second) reports.push_back(report_image(file));
    };
    for (const Texture& texture : scene.textures)
        if (texture.kind == TextureKind::Image) add(texture.file);
    if (scene.background.kind == BackgroundKind::Image) add(scene.background.file);
    if (scene.background.backdrop == BackdropKind::Image) add(scene.background.backdrop_file);
    return reports;
}

}  // namespace

SceneReport report_scene(const Scene& scene) {
    const Scene expanded = expand_generators(scene);
    SceneReport report;
    report.objects = count_shapes(expanded.objects);
    report.materials = count_kinds<MaterialKind>(expanded.materials);
    report.textures = count_kinds<TextureKind>(expanded.textures);
    report.images = report_images(expanded);
    report.generators = static_cast<int64_t>(scene.generators.size());
    report.generated_objects = static_cast<int64_t>(expanded.objects.size() - scene.objects.size());
    report.hidden_objects = std::count_if(expanded.objects.begin(), expanded.objects.end(),
                                          [](const Object& object) { return !object.visible; });

    SceneArrays arrays;
    flatten(expanded, SceneParts::All, arrays);
    report.lights = static_cast<int64_t>(arrays.lights.size());
    report.tree_nodes = static_cast<int64_t>(arrays.nodes.size());
    report.tree_depth = arrays.bvh.depth;
    report.tree_cost = arrays.bvh.sah_cost;
    report.build_seconds = arrays.bvh.build_seconds;
    report.scene_bytes = arrays.bytes();
    return report;
}

int64_t total(const KindCounts& counts) {
    int64_t sum = 0;
    for (const auto& [kind, count] : counts)
        sum += count;
    return sum;
}

}  // namespace tp
